// SPDX-License-Identifier: MIT
#include "results/study.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, StudyKey& r) {
  v.key("key", r.key, {"", "key"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("values", r.values, {"", "values"});
}

void describe(Visitor& v, StudyCell& r) {
  v.key("full", r.full, {"", "in full, in the unit of its column"});
  v.key("shown", r.shown, {"", "as people read it"});
}

void describe(Visitor& v, StudyColumn& r) {
  v.key("name", r.name, {"", "name"});
  v.key("title", r.title, {"", "title"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("cells", r.cells, {"", "cells, one for each variant"});
  v.key("kind", r.kind, {"", "what it is of"});
  v.key("by", r.by, {"", "method or criterion of a factor of safety"});
}

void describe(Visitor& v, StudyVariant& r) {
  v.key("name", r.name, {"", "name"});
  v.key("folder", r.folder, {"", "folder"});
  v.key("status", r.status, {"", "how it went"});
  v.key("reason", r.reason, {"", "why it is not finished"});
}

void describe(Visitor& v, ExtrapolatedFactor& r) {
  v.key("criterion", r.criterion, {"", "factor"});
  v.key("by", r.by, {"", "method or criterion"});
  v.key("variant", r.variant, {"", "other keys"});
  v.key("sizes", r.sizes, {"", "values of the key"});
  v.key("factors", r.factors, {"", "factors"});
  v.key("linear", r.linear, {"", "line through all"});
  v.key("standard_error", r.standard_error, {"", "standard error of it"});
  v.key("finest_pair", r.finest_pair, {"", "line through the finest two"});
  v.key("order", r.order, {"", "order p"});
  v.key("by_order", r.by_order, {"", "with order p"});
}

void describe(Visitor& v, StudyExtrapolation& r) {
  v.key("key", r.key, {"", "key"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("factors", r.factors, {"", "factors"});
}

void describe(Visitor& v, StudyUnits& r) {
  v.key("displacement", r.displacement, {"", "unit of displacements"});
  v.key("length", r.length, {"", "unit of lengths"});
  v.maybe("stress", r.stress, {"", "unit of stresses"});
}

void describe(Visitor& v, StudyResult& r) {
  v.key("format", r.format, {"", "version of this file"});
  v.key("title", r.title, {"", "title"});
  v.key("case_file", r.case_file, {"", "case file"});
  v.key("mode", r.mode, {"", "how values were combined"});
  v.key("reference", r.reference, {"", "variant that displacements are divided by"});
  v.key("vary", r.vary, {"", "keys that were varied"});
  v.key("columns", r.columns, {"", "table, column by column"});
  v.key("variants", r.variants, {"", "how each variant went"});
  v.key("notes", r.notes, {"", "notes"});
  v.key("units", r.units, {"", "units of display"});
  v.maybe("extrapolation", r.extrapolation, {"", "factors extrapolated over a key"});
  v.maybe("sampling", r.sampling, {"", "uncertain numbers"});
  v.maybe("back_analysis", r.back_analysis, {"", "value of a key at which a result reaches its target"});
  v.maybe("project", r.project, {"", "title block"});
  v.maybe("provenance", r.provenance, {"", "program, machine and input"});
  v.maybe("input", r.input, {"", "every key of the case"});
}

void describe(Visitor& v, JobChange& r) {
  v.key("key", r.key, {"", "key"});
  v.key("value", r.value, {"", "its value as TOML"});
}

void describe(Visitor& v, JobFile& r) {
  v.key("name", r.name, {"", "file"});
  v.key("hash", r.hash, {"", "hash of its content"});
}

void describe(Visitor& v, JobVariant& r) {
  v.key("folder", r.folder, {"", "folder"});
  v.key("label", r.label, {"", "name"});
  v.key("changes", r.changes, {"", "what it changes in the case"});
}

void describe(Visitor& v, JobPart& r) {
  v.key("first", r.first, {"", "first variant or sample, counted from 0"});
  v.key("end", r.end, {"", "the one after the last"});
}

void describe(Visitor& v, StudyJobs& r) {
  v.key("version", r.version, {"", "version of the program"});
  v.key("commit", r.commit, {"", "its source"});
  v.key("level", r.level, {"", "its instruction set"});
  v.key("title", r.title, {"", "title"});
  v.key("case_file", r.case_file, {"", "case file"});
  v.key("files", r.files, {"", "copies of the case and of the files that it names"});
  v.key("changes", r.changes, {"", "changes of the case"});
  v.key("work", r.work, {"", "what a job calculates"});
  v.key("jobs", r.jobs, {"", "the part of each job"});
  v.key("variants", r.variants, {"", "the runs"});
}

void describe(Visitor& v, JobSurface& r) {
  v.key("name", r.name, {"", "name"});
  v.key("circle", r.circle, {"m", "centre and radius"});
  v.key("line", r.line, {"m", "points of a polyline"});
  v.key("from", r.from, {"m", "x of its left end"});
  v.key("to", r.to, {"m", "x of its right end"});
}

void describe(Visitor& v, JobSurfaces& r) {
  v.key("study", r.study, {"", "hash of the list of jobs"});
  v.key("surfaces", r.surfaces, {"", "slip surfaces"});
}

void describe(Visitor& v, JobResult& r) {
  v.key("study", r.study, {"", "hash of the list of jobs"});
  v.key("job", r.job, {"", "number of the job"});
  v.key("seconds", r.seconds, {"s", "wall time"});
  v.key("code", r.code, {"", "exit code of the gravest failure"});
  v.key("reason", r.reason, {"", "why samples have no result"});
  v.key("variants", r.variants, {"", "how each run ended"});
  v.key("codes", r.codes, {"", "exit code of each run"});
  v.key("factors", r.factors, {"", "factor of safety of each sample"});
}

}  // namespace talus::results
