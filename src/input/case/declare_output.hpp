#pragma once
// [output] and [study]: what is stored and shown, and which keys are varied.

#include "input/case/case.hpp"
#include "input/case/declare_sampling.hpp"

namespace talus::input {

template <class Visitor>
void describe(Visitor& v, Monitor& m) {
  v.key("name", m.name, plain().required().example(R"("crest")"), "Name of the monitor in the histories.");
  v.key("at", m.at, quantity("m").required().example("[12, 15]"),
        "The nearest material point at the start is followed.");
}

template <class Visitor>
void describe(Visitor& v, Section& s) {
  v.key("name", s.name, plain().required().example(R"("A")"), "Name of the section, and of its file in sections/.");
  v.key("from", s.from, quantity("m").required().example("[6, 0]"), "Where the line begins.");
  v.key("to", s.to, quantity("m").required().example("[6, 5]"), "Where it ends.");
  v.key("width", s.width, quantity("m").above(0).example("0.2"),
        "Points within half of this from the line count, in parts of the line of this length; if not given, the mean "
        "size of the elements with soil.");
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
  v.key(
      "count_from", o.count_from, plain().example(R"("rain")"),
      "Stage at whose start the clock of onset, sections and pictures stands at zero; if not given, the last one with "
      "reset_displacement = true, or the first.");
  v.key("onset_displacement", o.onset_displacement, quantity("m").above(0).example(R"("5 cm")"),
        "A monitor has begun to move when its displacement in these stages exceeds this, and soil whose displacement "
        "does "
        "counts in the runout. Give more than what settlement or wetting alone does.");
  v.key("onset_ratio", o.onset_ratio,
        plain().above(0).allowed_without("onset_displacement", o.onset_displacement.has_value()),
        "The same as a share of the relief of the ground.");
  v.key("shown_times", o.shown_times, quantity("s").at_least(0).example("[0, 200, 400, 560]"),
        "Times on that clock at which the report shows sections and, for a study, pictures; if not given, five of the "
        "stored frames. The nearest stored frame is shown.");
  v.tables("monitor", o.monitors, 0, "A material point whose motion and stress are recorded.");
  v.tables("section", o.sections, 0, "A line along which the fields of the stored frames are written as a table.");
}

template <class Visitor>
void describe(Visitor& v, Vary& w) {
  v.key("key", w.key, plain().required().example(R"("materials.sand.cohesion")"),
        "The key to vary, written as for --set.");
  TomlTexts values{w.values};
  v.key("values", values, plain().required().example("[5, 10, \"15 kPa\"]"), "Its values.");
  TomlTexts names{w.names};
  v.key("names", names, plain().example("[\"weak\", \"as tested\", \"strong\"]"),
        "Names of the variants with these values, for tables, charts and folders; if not given, \"cohesion = 5\".");
}

template <class Visitor>
void describe(Visitor& v, Study& s) {
  v.key("mode", s.mode, plain(), "How the values of several keys are combined.");
  v.key("factors", s.factors, plain().above(0).example("[1.2, 1.4]"),
        "Strength reduction factors whose displacement the table of the study lists.");
  v.key("base_name", s.base_name, plain(), "Name of the case as the file has it.");
  v.key("reference", s.reference, plain(),
        "The variant that the displacements of the monitors are divided by: its name in the table, such as "
        "\"content = 0.51\", or that of its folder.");
  v.key("extrapolate", s.extrapolate, plain().example(R"("mesh.size")"),
        "One of the varied keys, to whose value zero the factors of safety are extrapolated (Richardson).");
  describe_sampling(v, s);
  v.tables("vary", s.vary, 0, "A key and the values it takes in `talus study`.");
  v.tables("random", s.sampling.numbers, 0, "An uncertain number, for mode = \"sample\".");
  v.tables("correlation", s.sampling.correlations, 0, "Two of these numbers that go together.");
}

}  // namespace talus::input
