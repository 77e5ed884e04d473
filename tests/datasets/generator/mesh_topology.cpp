// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/datasets/generator/mesh_topology.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

// Around every vertex, from the end of each outgoing edge to that of the next one: a closed fan is one cycle.
bool fans_are_cycles(const Shape& mesh) {
  std::vector<std::map<std::int32_t, std::int32_t>> next(static_cast<std::size_t>(mesh.vertices.rows()));
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      auto& fan = next[static_cast<std::size_t>(mesh.triangles(f, k))];
      fan[mesh.triangles(f, (k + 1) % 3)] = mesh.triangles(f, (k + 2) % 3);
    }
  }
  for (const auto& fan : next) {
    if (fan.empty()) return false;  // a vertex that no triangle uses
    std::size_t steps = 0;
    std::int32_t at = fan.begin()->first;
    do {
      const auto found = fan.find(at);
      if (found == fan.end()) return false;
      at = found->second;
      ++steps;
    } while (at != fan.begin()->first && steps <= fan.size());
    if (steps != fan.size()) return false;
  }
  return true;
}

std::size_t component_count(const Shape& mesh) {
  std::vector<std::int32_t> parent(static_cast<std::size_t>(mesh.vertices.rows()));
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = static_cast<std::int32_t>(i);
  const auto root = [&parent](std::int32_t i) {
    while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
    return i;
  };
  std::size_t count = parent.size();
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    for (int k = 1; k < 3; ++k) {
      const std::int32_t a = root(mesh.triangles(f, 0));
      const std::int32_t b = root(mesh.triangles(f, k));
      if (a == b) continue;
      parent[static_cast<std::size_t>(b)] = a;
      --count;
    }
  }
  return count;
}

}  // namespace

std::string topology_fault(const Shape& mesh) {
  std::map<Edge, int> uses;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) ++uses[{mesh.triangles(f, k), mesh.triangles(f, (k + 1) % 3)}];
  }
  if (uses.empty()) return "no triangles";
  for (const auto& [edge, count] : uses) {
    if (edge.first == edge.second) return "a triangle with a vertex twice";
    if (count != 1) return "two triangles on one side of an edge";
    if (!uses.contains({edge.second, edge.first})) return "an open edge";
  }
  if (!fans_are_cycles(mesh)) return "a vertex that is not manifold";
  if (component_count(mesh) != 1) return "more than one component";
  if (test::signed_volume(mesh) <= 0) return "oriented inward";
  return "";
}

}  // namespace shapegauge
