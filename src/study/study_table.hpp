// SPDX-License-Identifier: MIT
#pragma once
// What a study shows: one table as CSV and as Markdown, and the curves of all variants in one picture.

#include <filesystem>
#include <string>
#include <vector>

#include "study/study.hpp"

namespace talus::study {

/// The table of a study. Columns that no variant fills are left out, except those of the varied keys and the factors.
std::vector<results::StudyColumn> make_study_table(const StudyPlan& plan, const std::vector<StudyRow>& rows);

std::string write_study_csv(const std::vector<results::StudyColumn>& table);

/// Plan, table and how each variant went, for the report; numbers in `full` are in the unit of their column.
results::StudyResult describe_study(const StudyPlan& plan, const std::vector<StudyRow>& rows);

/// The same as Markdown, with the reasons for missing values and the warnings of the runs below.
std::string write_study_markdown(const StudyPlan& plan, const std::vector<StudyRow>& rows,
                                 const results::StudyResult& study);

/// study.csv, study.json and study.md in `folder`. Throws Error (cannot_write).
void write_study_tables(const StudyPlan& plan, const std::vector<StudyRow>& rows, const std::filesystem::path& folder);

/// The tables and all pictures. Errors as for them.
void write_study(const StudyPlan& plan, const std::vector<StudyRow>& rows, const std::filesystem::path& folder);

/// The displacement curves of all variants; nothing is drawn when there is none. Errors as for output::draw.
void draw_study(const StudyPlan& plan, const std::vector<StudyRow>& rows, const std::filesystem::path& picture);

/// Displacement of each monitor over time in all variants: displacement_NAME.svg in `folder`; errors as above.
void draw_motion(const StudyPlan& plan, const std::vector<StudyRow>& rows, const std::filesystem::path& folder);

}  // namespace talus::study
