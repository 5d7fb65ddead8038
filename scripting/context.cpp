#include "scripting/context.hpp"

#include "engine/model/check.hpp"
#include "scripting/sandbox.hpp"

#include <fstream>
#include <sstream>
#include <system_error>

namespace demlua::scripting {

Context::Context(const Overrides& set, Host* program)
    : overrides(set), host(program), interpreter(std::make_shared<Interpreter>(*this)) {
    open_sandbox(interpreter->L);
}

Context::~Context() { interpreter->context = nullptr; }

observe::Simulation* Context::simulation() const {
    if (watched != nullptr) return watched;
    return host == nullptr ? nullptr : host->simulation();
}

void Context::require_run() const {
    if (runs.empty()) throw LuaFailure("there is nothing to read before the first sim:run");
}

double Context::time() const {
    const observe::Simulation* const running = simulation();
    return running == nullptr ? skipped_time : running->time();
}

void Context::complain(Problem problem, Cause cause) {
    ++complaints;
    const bool in_doubt = !simulates() && !runs.empty() && cause == Cause::value;
    if (in_doubt) return;
    blamed.insert({problem.place.file, problem.place.line});
    problems.push_back(std::move(problem));
}

void Context::check_model() {
    for (Problem& problem : model::check(scene, observe::measurable_fields())) {
        if (blamed.count({problem.place.file, problem.place.line}) == 0) problems.push_back(std::move(problem));
    }
}

void Context::throw_problems() const {
    if (!problems.empty()) throw SceneError(problems);
}

namespace {

std::string text_of_file(const std::filesystem::path& path) {
    const Place place{path.string(), 0};
    std::error_code failure;
    if (std::filesystem::is_directory(path, failure)) throw SceneError(Problem{place, "is a folder", "", "", ""});
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        const bool there = std::filesystem::exists(path, failure);
        throw SceneError(Problem{place, there ? "cannot be read" : "no such file", "", "", ""});
    }
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

} // namespace

void Context::run_file(const std::filesystem::path& name, const std::map<std::string, Plain>& values, int results) {
    files.push_back({name, text_of_file(name)});
    interpreter->load(interpreter->L, files.back().text, name.string());
    inclusions.push_back({name, values});
    interpreter->call(interpreter->L, 0, results);
    inclusions.pop_back();
}

} // namespace demlua::scripting
