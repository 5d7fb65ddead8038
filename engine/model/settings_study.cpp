// dem.study and dem.compare: what is asked of the results of a scene.
#include "engine/model/rows.hpp"
#include "engine/model/settings.hpp"

namespace demlua::model {

using namespace rows;

namespace {

Slot vary_slot(void* /*o*/) { return OwnSlot{"lists of values by parameter", "table<string, any[]>"}; }
Slot reference_slot(void* /*o*/) {
    return OwnSlot{"a number, a function of the parameters or \"finest\"",
                   "number|\"finest\"|fun(parameters: table): number"};
}
Slot size_slot(void* /*o*/) {
    return OwnSlot{"the name of a varied parameter or a function of the parameters",
                   "string|fun(parameters: table): number"};
}
Slot seeds_slot(void* /*o*/) { return OwnSlot{"a count or a list of whole numbers", "integer|integer[]"}; }
Slot tolerance_slot(void* /*o*/) {
    return OwnSlot{"a number or a function of the parameters", "number|fun(parameters: table): number"};
}

constexpr Range at_least_one{"must be at least 1", [](double v) { return v >= 1.0; }};

template <class T>
Row<T> own(std::string name, Slot (*slot)(void*), std::string meaning) {
    return {{std::move(name), slot, {}, optional, any, std::move(meaning), by_name_only}};
}

} // namespace

namespace words {

const WordOf<StudySaid>& study() {
    using S = StudySaid;
    static const WordOf<S> made = word<S>(
        "dem.study",
        "Declares what `demlua study FILE.lua` varies and measures; a plain run takes no notice of it. It is best said "
        "before the first sim:run. Several varied parameters give all their combinations.",
        "",
        R"(dem.study { vary = { radius = { 8e-3, 4e-3, 2e-3 } }, measure = "critical_stress", reference = 2.6e6, unit = "Pa" })",
        {own<S>("vary", vary_slot, "what is varied"),
         row<&S::measure>("measure", required, "the name under which dem.result publishes the quantity"),
         row<&S::unit>("unit", optional, "of the quantity"),
         own<S>("reference", reference_slot,
                "what the quantity should be; without it dem.result must publish `reference`"),
         own<S>(
             "size", size_slot,
             "the element size, or what goes to zero in its place: the varied number, which must be named when there "
             "are several; its values make the levels, the others series"),
         own<S>("seeds", seeds_slot, "values of the parameter `seed` at each level; a count n stands for 1 to n"),
         row<&S::repeats>("repeats", "", optional, at_least_one, "how often each run is timed; the shortest counts"),
         own<S>("tolerance", tolerance_slot,
                "the greatest relative error that validation accepts at the finest level run"),
         row<&S::order>("order", optional, "between which two numbers validation accepts the order of the error"),
         row<&S::because>("because", optional, "why the tolerance is what it is"),
         row<&S::source>("source", optional, "of the reference")});
    return made;
}

const WordOf<Comparison>& compare() {
    using C = Comparison;
    static const WordOf<C> made = word<C>(
        "dem.compare",
        "Sets a value beside what it should be: in the run's summary, on the terminal, and in docs/validation.md for "
        "the "
        "scenes listed there.",
        "",
        R"(dem.compare { what = "period", unit = "s", value = period, reference = 2 * math.pi * math.sqrt(m / k), tolerance = 1e-3, because = "the step's own error is 8e-4" })",
        {row<&C::what>("what", required, "the quantity"), row<&C::value>("value", "", required, any, "what came out"),
         row<&C::reference>("reference", "", required, any, "what it should be"),
         row<&C::unit>("unit", optional, "of both"),
         row<&C::tolerance>(
             "tolerance", "", optional, positive,
             "the greatest relative error (difference where the reference is zero) that validation accepts"),
         row<&C::because>("because", optional, "why the tolerance is what it is"),
         row<&C::source>("source", optional, "of the reference")});
    return made;
}

} // namespace words

} // namespace demlua::model
