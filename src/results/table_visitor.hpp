// SPDX-License-Identifier: MIT
#pragma once
// Conversion of any described struct to tables.

#include <deque>
#include <set>

#include "results/described.hpp"
#include "results/tables.hpp"

namespace talus::results {

/// Structs that tables treat in a way of their own.
struct TableRules {
  std::set<const Type*> left_out;     ///< no table includes them
  std::set<const Type*> columns;      ///< their lists are the columns of one table, such as those of slices
  std::set<const Type*> own_columns;  ///< of a list, whose lists of numbers, as long as the first, are such columns
  std::set<const Type*> in_head;      ///< belong to the overview
};

/// Returns the tables of a described struct.
std::deque<Table> visit_tables(Value result, const TableRules& rules, const ShownUnits& units, std::size_t dimension);

}  // namespace talus::results
