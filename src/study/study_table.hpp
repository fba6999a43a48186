// SPDX-License-Identifier: MIT
#pragma once
// Output of a study: one table as CSV and as Markdown, and the curves of all variants in one picture.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/study.hpp"
#include "study/study_plan.hpp"

namespace talus::study {

/// Makes the table of a study. Columns without values are left out, except those of the varied keys and the factors.
std::vector<results::StudyColumn> make_study_table(const StudyPlan& plan, const std::vector<StudyRow>& rows);

/// Returns the name of the column of a result; a result without one in every study has a column of its own name.
std::string find_result_column(const std::string& name);

std::string write_study_csv(const std::vector<results::StudyColumn>& table);

/// Makes plan, table and outcome of each variant for the report; numbers in `full` are in the unit of their column.
results::StudyResult describe_study(const StudyPlan& plan, const std::vector<StudyRow>& rows);

/// Formats the table as Markdown, followed by the reasons for missing values and the warnings of the runs.
std::string write_study_markdown(const StudyPlan& plan, const std::vector<StudyRow>& rows,
                                 const results::StudyResult& study);

/// Writes study.csv, study.json and study.md in `folder`. Throws Error (cannot_write).
void write_study_tables(const StudyPlan& plan, const std::vector<StudyRow>& rows, const std::filesystem::path& folder);

/// Writes the tables and all pictures. Throws what these functions throw.
void write_study(const StudyPlan& plan, const std::vector<StudyRow>& rows, const std::filesystem::path& folder);

/// Draws the displacement curves of all variants; draws nothing if there is none. Throws what output::draw throws.
void draw_study(const StudyPlan& plan, const std::vector<StudyRow>& rows, const std::filesystem::path& picture);

/// Draws the displacement of each monitor over time in all variants, displacement_NAME.svg in `folder`. Throws what
/// output::draw throws.
void draw_motion(const StudyPlan& plan, const std::vector<StudyRow>& rows, const std::filesystem::path& folder);

// Richardson extrapolation of factors on several mesh sizes to size zero, with an estimate of its error.
// docs/theory/factor-of-safety.md has the equations.

/// Fits F(h) = F_0 + C h^p to factors F(h) at several sizes h. Returns F_0 of the least squares line, p = 1, with its
/// standard error from three sizes on; F_0 of the line through the two finest; and F_0 with the best-fitting p in
/// [1/2, 4], from four sizes on. Sizes are sorted from coarse to fine. Throws Error (wrong_input) for fewer than two,
/// and for sizes that are not positive and distinct.
results::ExtrapolatedFactor extrapolate(const std::vector<double>& sizes, const std::vector<double>& factors);

/// Extrapolates every factor of the table that was computed at two or more values of the key with all other varied
/// keys equal. Returns nullopt if the study extrapolates none.
std::optional<results::StudyExtrapolation> extrapolate_factors(const StudyPlan& plan,
                                                               const std::vector<results::StudyColumn>& table);

/// Formats the extrapolation as a table in Markdown; empty without factors. `name` is the short name of the key.
std::string write_extrapolation_markdown(const results::StudyExtrapolation& extrapolation, const std::string& name);

}  // namespace talus::study
