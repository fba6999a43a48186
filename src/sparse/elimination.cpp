// SPDX-License-Identifier: MIT
#include "sparse/elimination.hpp"

#include <metis.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cstddef>
#include <mutex>
#include <numeric>

namespace talus::sparse {
namespace {

/// Multiplications above which nested dissection is tried: three-dimensional meshes, on which minimum degree needs two
/// to three times the work.
constexpr double much_work = 1e9;
/// A front takes in a child if the entries of both are zeros by no more than this fraction, for numbers of pivots up to
/// `pivots` (Ashcraft and Grimes 1989). Few large fronts are faster than many small ones.
struct Merger {
  int pivots;
  double zeros;
};
constexpr Merger mergers[] = {{4, 1}, {16, 0.8}, {48, 0.1}};
constexpr double most_zeros = 0.05;  ///< for all larger fronts

/// Graph of the groups of consecutive unknowns that have one pattern, such as the displacements of a node.
struct Graph {
  std::vector<int> first, size;           ///< first unknown of each group, and their number
  std::vector<int> start{0}, neighbours;  ///< groups that each group is coupled with, without itself
  int count() const { return static_cast<int>(size.size()); }
};

Graph group_unknowns(const std::vector<int>& column_start, const std::vector<int>& row) {
  Graph graph;
  const int unknowns = static_cast<int>(column_start.size()) - 1;
  std::vector<int> group(unknowns);
  for (int j = 0; j < unknowns; ++j) {
    const auto column = row.begin() + column_start[j], end = row.begin() + column_start[j + 1];
    const bool is_new = j == 0 || end - column != column_start[j] - column_start[j - 1] ||
                        !std::equal(column, end, row.begin() + column_start[j - 1]);
    if (is_new) graph.first.push_back(j), graph.size.push_back(0);
    group[j] = graph.count() - 1;
    ++graph.size.back();
  }
  for (int a = 0; a < graph.count(); ++a) {
    int last = a;
    for (int k = column_start[graph.first[a]]; k < column_start[graph.first[a] + 1]; ++k) {
      const int b = group[row[k]];
      if (b != a && b != last) graph.neighbours.push_back(b);
      if (b != a) last = b;
    }
    graph.start.push_back(static_cast<int>(graph.neighbours.size()));
  }
  return graph;
}

/// An order of groups: the group at each position.
using Order = std::vector<int>;

Order order_by_minimum_degree(const Graph& graph) {
  Eigen::SparseMatrix<double> pattern(graph.count(), graph.count());
  std::vector<int> width(graph.count());
  for (int a = 0; a < graph.count(); ++a) width[a] = graph.start[a + 1] - graph.start[a] + 1;
  pattern.reserve(width);
  for (int a = 0; a < graph.count(); ++a) {
    pattern.insert(a, a) = 1;
    for (int k = graph.start[a]; k < graph.start[a + 1]; ++k) pattern.insert(graph.neighbours[k], a) = 1;
  }
  Eigen::AMDOrdering<int>::PermutationType found;
  Eigen::AMDOrdering<int>()(pattern, found);
  return {found.indices().begin(), found.indices().end()};
}

Order order_by_nested_dissection(const Graph& graph) {
  // METIS draws its random numbers from rand(), and replaces the handlers of SIGTERM and SIGABRT meanwhile, which
  // catch_interrupts() allows for.
  static std::mutex one;
  const std::lock_guard lock(one);
  std::vector<idx_t> start(graph.start.begin(), graph.start.end()),
      neighbours(graph.neighbours.begin(), graph.neighbours.end()), weight(graph.size.begin(), graph.size.end()),
      order(graph.size.size()), position(graph.size.size());
  idx_t count = graph.count(), options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  const int end =
      METIS_NodeND(&count, start.data(), neighbours.data(), weight.data(), options, order.data(), position.data());
  return end == METIS_OK ? Order(order.begin(), order.end()) : Order{};
}

/// Returns the parent of each position in the elimination tree; -1 at a root (Liu 1990).
std::vector<int> find_parents(const Graph& graph, const Order& order, const std::vector<int>& position) {
  std::vector<int> parent(graph.count(), -1), ancestor(graph.count(), -1);
  for (int j = 0; j < graph.count(); ++j)
    for (int k = graph.start[order[j]]; k < graph.start[order[j] + 1]; ++k)
      for (int i = position[graph.neighbours[k]]; i < j && i != -1;) {
        const int next = ancestor[i];
        ancestor[i] = j;
        if (next == -1) parent[i] = j;
        i = next == j ? -1 : next;
      }
  return parent;
}

/// Fronts while they are formed from groups, one for each position; those that were merged into another have no groups.
struct Draft {
  std::vector<int> groups;  ///< positions of the pivots
  std::vector<int> rows;    ///< positions of the other groups of the front
  std::vector<int> children;
  int pivots = 0, row_count = 0;
  double zeros = 0;  ///< entries of the lower triangle that merging has added
};

std::vector<Draft> find_columns(const Graph& graph, const Order& order, const std::vector<int>& position,
                                const std::vector<int>& parent) {
  std::vector<Draft> drafts(graph.count());
  std::vector<int> seen_by(graph.count(), -1);
  for (int j = 0; j < graph.count(); ++j) {
    Draft& draft = drafts[j];
    const auto add = [&](int i) {
      if (i <= j || seen_by[i] == j) return;
      seen_by[i] = j;
      draft.rows.push_back(i);
      draft.row_count += graph.size[order[i]];
    };
    for (int k = graph.start[order[j]]; k < graph.start[order[j] + 1]; ++k) add(position[graph.neighbours[k]]);
    for (const int child : draft.children)
      for (const int i : drafts[child].rows) add(i);
    draft.groups = {j};
    draft.pivots = graph.size[order[j]];
    if (parent[j] >= 0) drafts[parent[j]].children.push_back(j);
  }
  return drafts;
}

bool is_worth_merging(int pivots, int row_count, double zeros) {
  const double width = pivots, entries = 0.5 * width * (width + 1) + width * row_count;
  for (const Merger& merger : mergers)
    if (pivots <= merger.pivots && zeros <= merger.zeros * entries) return true;
  return zeros <= most_zeros * entries;
}

/// Merges children into their parents from the bottom up.
void merge(std::vector<Draft>& drafts) {
  for (Draft& parent : drafts) {
    std::vector<int> kept, children = parent.children;
    std::stable_sort(children.begin(), children.end(),
                     [&](int a, int b) { return drafts[a].row_count > drafts[b].row_count; });
    for (const int c : children) {
      Draft& child = drafts[c];
      const double added = parent.pivots + parent.row_count - child.row_count;
      const double zeros = child.zeros + parent.zeros + child.pivots * added;
      if (!is_worth_merging(child.pivots + parent.pivots, parent.row_count, zeros)) {
        kept.push_back(c);
        continue;
      }
      parent.zeros = zeros;
      parent.pivots += child.pivots;
      parent.groups.insert(parent.groups.end(), child.groups.begin(), child.groups.end());
      kept.insert(kept.end(), child.children.begin(), child.children.end());
      child = {};
    }
    parent.children = std::move(kept);
  }
}

/// Returns the drafts that were not merged, in postorder.
std::vector<int> list_in_postorder(const std::vector<Draft>& drafts, const std::vector<int>& parent) {
  std::vector<int> list;
  std::vector<std::pair<int, std::size_t>> path;  // a draft, and the number of its children that are listed
  for (int root = 0; root < static_cast<int>(drafts.size()); ++root) {
    if (parent[root] >= 0) continue;
    path.push_back({root, 0});
    while (!path.empty()) {
      auto& [j, listed] = path.back();
      if (listed < drafts[j].children.size()) {
        path.push_back({drafts[j].children[listed++], 0});
      } else {
        list.push_back(j);
        path.pop_back();
      }
    }
  }
  return list;
}

/// Completes the fronts by what their parents and descendants have.
void link(Elimination& plan) {
  for (std::size_t f = 0; f < plan.fronts.size(); ++f) {
    Front& front = plan.fronts[f];
    front.first_of_subtree =
        front.children.empty() ? static_cast<int>(f) : plan.fronts[front.children[0]].first_of_subtree;
    double own = 0;
    for (int p = 0; p < front.pivots; ++p) {
      const double left = front.size() - p;
      own += left * left;
    }
    plan.work += own;
    front.work = own;
    for (const int child : front.children) front.work += plan.fronts[child].work;
    if (front.parent < 0) continue;
    const Front& parent = plan.fronts[front.parent];
    for (int i = 0; i < static_cast<int>(front.rows.size()); ++i) {
      const int to = parent.find(front.rows[i]);
      const bool goes_on = !front.runs.empty() && to == front.runs.back().to + front.runs.back().count;
      if (!goes_on || to == parent.pivots) front.runs.push_back({i, to, 0});
      ++front.runs.back().count;
    }
  }
}

Elimination plan_in_order(const Graph& graph, const Order& order) {
  std::vector<int> position(order.size());
  for (int j = 0; j < graph.count(); ++j) position[order[j]] = j;
  const std::vector<int> parent = find_parents(graph, order, position);
  std::vector<Draft> drafts = find_columns(graph, order, position, parent);
  merge(drafts);
  const std::vector<int> list = list_in_postorder(drafts, parent);

  Elimination plan;
  plan.position.resize(static_cast<std::size_t>(graph.first.back()) + static_cast<std::size_t>(graph.size.back()));
  plan.fronts.resize(list.size());
  std::vector<int> first(order.size()), front_of(order.size());  // of each position
  int next = 0;
  for (std::size_t f = 0; f < list.size(); ++f) {
    Draft& draft = drafts[list[f]];
    Front& front = plan.fronts[f];
    front.first = next;
    front.pivots = draft.pivots;
    front_of[list[f]] = static_cast<int>(f);
    std::sort(draft.groups.begin(), draft.groups.end());
    for (const int j : draft.groups) {
      first[j] = next;
      for (int k = 0; k < graph.size[order[j]]; ++k) plan.position[graph.first[order[j]] + k] = next++;
    }
    for (const int child : draft.children) {
      front.children.push_back(front_of[child]);
      plan.fronts[front_of[child]].parent = static_cast<int>(f);
    }
  }
  for (std::size_t f = 0; f < list.size(); ++f) {
    std::vector<int>& rows = plan.fronts[f].rows;
    for (const int j : drafts[list[f]].rows)
      for (int k = 0; k < graph.size[order[j]]; ++k) rows.push_back(first[j] + k);
    std::sort(rows.begin(), rows.end());
  }
  link(plan);
  return plan;
}

}  // namespace

int Front::find(int unknown) const {
  if (unknown < first + pivots) return unknown - first;
  return pivots + static_cast<int>(std::lower_bound(rows.begin(), rows.end(), unknown) - rows.begin());
}

Elimination plan_elimination(const std::vector<int>& column_start, const std::vector<int>& row) {
  const Graph graph = group_unknowns(column_start, row);
  if (graph.count() == 0) return {};
  Elimination plan = plan_in_order(graph, order_by_minimum_degree(graph));
  if (plan.work <= much_work) return plan;
  const Order order = order_by_nested_dissection(graph);
  if (order.empty()) return plan;
  Elimination other = plan_in_order(graph, order);
  return other.work < plan.work ? std::move(other) : std::move(plan);
}

}  // namespace talus::sparse
