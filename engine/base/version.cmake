# Script mode: writes OUTPUT from INPUT with the git revision of SOURCE_DIR ("-dirty" appended when
# tracked files were changed). Touches OUTPUT only when its content changes.
set(REVISION "unknown")
find_program(GIT git)
# Without its own .git the tree is an unpacked archive, perhaps inside another repository.
if(GIT AND EXISTS ${SOURCE_DIR}/.git)
    execute_process(
        COMMAND ${GIT} describe --always --dirty --abbrev=12 --exclude=*
        WORKING_DIRECTORY ${SOURCE_DIR}
        OUTPUT_VARIABLE description OUTPUT_STRIP_TRAILING_WHITESPACE
        RESULT_VARIABLE failed ERROR_QUIET)
    if(NOT failed)
        set(REVISION "${description}")
    endif()
endif()
configure_file(${INPUT} ${OUTPUT} @ONLY)
