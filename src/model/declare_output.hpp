#pragma once
// [output] and [study]: what is stored and shown, and which keys are varied.

#include "model/case.hpp"
#include "model/codec.hpp"

namespace talus::model {

template <>
inline constexpr auto choices<StudyMode> = std::array{
    Choice{StudyMode::one_at_a_time, "one_at_a_time", "each value alone, the other keys as in the file"},
    Choice{StudyMode::grid, "grid", "every combination of the values"},
};

template <class Visitor>
void describe(Visitor& v, Monitor& m) {
  v.key("name", m.name, plain().required().example(R"("crest")"), "Name of the monitor in the histories.");
  v.key("at", m.at, quantity("m").required().example("[12, 15]"),
        "The nearest material point at the start is followed.");
}

template <class Visitor>
void describe(Visitor& v, Output& o) {
  v.key("frame_interval", o.frame_interval, quantity("s").at_least(0),
        "Simulated time between stored frames; 0: only at the end of each stage.");
  v.key("history_interval", o.history_interval, quantity("s").at_least(0),
        "Simulated time between rows of the histories; 0: 200 rows a stage.");
  v.key("checkpoint_interval", o.checkpoint_interval, quantity("s").above(0), "Wall time between checkpoints.");
  v.key("cells", o.cells, plain(), "Store the fields of the elements as well.");
  v.key("nodes", o.nodes, plain(), "Store the fields of the nodes as well.");
  v.key("length_unit", o.length_unit, plain(), "Unit of lengths in histories and plots.");
  v.key("displacement_unit", o.displacement_unit, plain(),
        "Unit of displacements in histories, study tables and plots.");
  v.key("stress_unit", o.stress_unit, plain(), "Unit of stresses in histories and plots.");
  v.tables("monitor", o.monitors, 0, "A material point whose motion and stress are recorded.");
}

template <class Visitor>
void describe(Visitor& v, Vary& w) {
  v.key("key", w.key, plain().required().example(R"("materials.sand.cohesion")"),
        "The key to vary, written as for --set.");
  TomlTexts values{w.values};
  v.key("values", values, plain().required().example("[5, 10, \"15 kPa\"]"), "Its values.");
}

template <class Visitor>
void describe(Visitor& v, Study& s) {
  v.key("mode", s.mode, plain(), "How the values of several keys are combined.");
  v.key("factors", s.factors, plain().above(0).example("[1.2, 1.4]"),
        "Strength reduction factors whose displacement the table of the study lists.");
  v.tables("vary", s.vary, 0, "A key and the values it takes in `talus study`.");
}

}  // namespace talus::model
