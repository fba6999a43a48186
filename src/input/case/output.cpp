// SPDX-License-Identifier: MIT
#include "input/case/output.hpp"

#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, Project& p) {
  v.key("name", p.name, plain().example(R"("Bypass, cut 3")"), "Name or number of the project.");
  v.key("client", p.client, plain().example(R"("County road office")"), "For whom.");
  v.key("author", p.author, plain().example(R"("A. Engineer")"), "Who prepared the case.");
  v.key("checked_by", p.checked_by, plain().example(R"("B. Engineer")"), "Who checked it.");
  v.key("revision", p.revision, plain().example(R"("A")"), "Revision of the case.");
  v.key("notes", p.notes, plain().example(R"("Preliminary design")"), "Anything a reader of the report must know.");
}

void describe(Visitor& v, Monitor& m) {
  v.key("name", m.name, plain().required().example(R"("crest")"), "Name of the monitor in the histories.");
  v.key("at", m.at, quantity("m").required().example("[12, 15]"),
        "The nearest material point at the start is followed.");
  Series settlement{m.settlement}, lateral{m.lateral}, pressure{m.pressure};
  v.key("measured_settlement", settlement, quantity("mm").example(R"([["0 day", 0], ["30 day", 42], ["90 day", 61]])"),
        "Measured settlement, rows of time and value or a column of a file: drawn over the computed one of the stages "
        "of construction, with the difference of both.");
  v.key("measured_lateral", lateral, quantity("mm").example(R"({ file = "inclinometer.csv", column = "top" })"),
        "Measured displacement along x, likewise.");
  v.key("measured_pressure", pressure, quantity("kPa").example(R"({ file = "piezometers.csv", column = "P1" })"),
        "Measured pore pressure, likewise.");
}

void describe(Visitor& v, SectionLine& s) {
  v.key("name", s.name, plain().required().example(R"("A")"), "Name of the section, and of its file in sections/.");
  v.key("from", s.from, quantity("m").required().example("[6, 0]"), "Where the line begins.");
  v.key("to", s.to, quantity("m").required().example("[6, 5]"), "Where it ends.");
  v.key("width", s.width, quantity("m").above(0).example("0.2"),
        "Points within half of this from the line count, in parts of the line of this length; if not given, the mean "
        "size of the elements with soil.");
}

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
  v.key("count_from", o.count_from, plain().example(R"("rain")"),
        "Stage at whose start the clock of onset, sections and pictures stands at zero; if not given, the last one "
        "with reset_displacement = true, or the first.");
  v.key("onset_displacement", o.onset_displacement, quantity("m").above(0).example(R"("5 cm")"),
        "A monitor has begun to move when its displacement in these stages exceeds this, and soil whose displacement "
        "does counts in the runout. Give more than what settlement or wetting alone does.");
  v.key("onset_ratio", o.onset_ratio,
        plain().above(0).allowed_without("onset_displacement", o.onset_displacement.has_value()),
        "The same as a share of the relief of the ground.");
  v.key("runout_meshes", o.runout_meshes, plain().at_least(1).at_most(2),
        "Meshes on which soil that moves is calculated. 2: also on elements twice as large, for about an eighth of the "
        "time more, so that front, runout and height have an interval: three times the difference of the two. 1: no "
        "interval.");
  v.key("shown_times", o.shown_times, quantity("s").at_least(0).example("[0, 200, 400, 560]"),
        "Times on that clock at which the report shows sections and, for a study, pictures; if not given, five of the "
        "stored frames. The nearest stored frame is shown.");
  v.tables("monitor", o.monitors, 0, "A material point whose motion and stress are recorded.");
  v.tables("section", o.sections, 0, "A line along which the fields of the stored frames are written as a table.");
}

}  // namespace talus::input
