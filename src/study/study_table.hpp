// SPDX-License-Identifier: MIT
#pragma once
// Output of a study: one table as CSV and as Markdown, and the curves of all variants in one picture.

#include <filesystem>
#include <string>
#include <vector>

#include "study/study.hpp"

namespace talus::study {

/// Makes the table of a study. Columns without values are left out, except those of the varied keys and the factors.
std::vector<results::StudyColumn> make_study_table(const StudyPlan& plan, const std::vector<StudyRow>& rows);

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

}  // namespace talus::study
