// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/edmonds_karp_max_flow.hpp>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/segmentation/alpha_expansion.h"

namespace shapegauge {
namespace {

using Labels = std::vector<std::int32_t>;

struct Problem {
  Eigen::MatrixXd costs;
  std::vector<LabelEdge> edges;
};

/// Costs are multiples of 1/8, so that sums are exact.
Problem arbitrary_problem(std::int32_t nodes, Eigen::Index labels) {
  Problem problem;
  problem.costs.resize(nodes, labels);
  for (double& cost : problem.costs.reshaped()) cost = *rc::gen::inRange(-16, 64) / 8.0;
  const auto edges = *rc::gen::inRange(0, 3 * nodes);
  for (int i = 0; i < edges; ++i) {
    const auto a = *rc::gen::inRange<std::int32_t>(0, nodes);
    const auto b = *rc::gen::inRange<std::int32_t>(0, nodes);
    if (a != b) problem.edges.push_back({a, b, *rc::gen::inRange(0, 40) / 8.0});
  }
  return problem;
}

/// Least cost of all labellings, by enumeration.
double min_cost(const Problem& problem) {
  Labels labels(static_cast<std::size_t>(problem.costs.rows()), 0);
  double least = std::numeric_limits<double>::infinity();
  while (true) {
    least = std::min(least, labelling_cost(labels, problem.costs, problem.edges));
    std::size_t i = 0;
    while (i < labels.size() && ++labels[i] == problem.costs.cols()) labels[i++] = 0;
    if (i == labels.size()) return least;
  }
}

/// Least cost of two labels as a minimum cut, by Boost's augmenting paths (Edmonds, Karp), in eighths.
double min_cost_by_boost(const Problem& problem) {
  using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
  using Graph = boost::adjacency_list<
      boost::vecS, boost::vecS, boost::directedS, boost::no_property,
      boost::property<boost::edge_capacity_t, long,
                      boost::property<boost::edge_residual_capacity_t, long,
                                      boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>>;
  const auto nodes = static_cast<std::size_t>(problem.costs.rows());
  Graph graph(nodes + 2);
  const auto capacity = get(boost::edge_capacity, graph);
  const auto reverse = get(boost::edge_reverse, graph);
  const auto connect = [&](std::size_t a, std::size_t b, long forward, long back) {
    const auto there = add_edge(a, b, graph).first;
    const auto again = add_edge(b, a, graph).first;
    capacity[there] = forward;
    capacity[again] = back;
    reverse[there] = again;
    reverse[again] = there;
  };
  const auto eighths = [](double cost) { return std::lround(8 * cost); };
  long constant = 0;
  for (std::size_t i = 0; i < nodes; ++i) {
    const long first = eighths(problem.costs(static_cast<Eigen::Index>(i), 0));
    const long second = eighths(problem.costs(static_cast<Eigen::Index>(i), 1));
    const long least = std::min(first, second);
    constant += least;
    connect(nodes, i, second - least, 0);
    connect(i, nodes + 1, first - least, 0);
  }
  for (const LabelEdge& edge : problem.edges) {
    const long cost = eighths(edge.cost);
    connect(static_cast<std::size_t>(edge.a), static_cast<std::size_t>(edge.b), cost, cost);
  }
  std::vector<boost::default_color_type> colours(nodes + 2);
  std::vector<Traits::edge_descriptor> predecessors(nodes + 2);
  const long flow = edmonds_karp_max_flow(graph, nodes, nodes + 1,
                                          boost::color_map(colours.data()).predecessor_map(predecessors.data()));
  return static_cast<double>(constant + flow) / 8;
}

RC_GTEST_PROP(AlphaExpansion, OfTwoLabelsMatchesTheMinimumCutByBoost, ()) {
  const auto nodes = *rc::gen::inRange<std::int32_t>(1, 40);
  const Problem problem = arbitrary_problem(nodes, 2);
  Labels start(static_cast<std::size_t>(nodes), 0);
  for (std::int32_t& label : start) label = *rc::gen::inRange(0, 2);
  const Labels labels = alpha_expansion(problem.costs, problem.edges, start);
  RC_ASSERT(labelling_cost(labels, problem.costs, problem.edges) == min_cost_by_boost(problem));
}

RC_GTEST_PROP(AlphaExpansion, CostExceedsTheOptimumByAtMostTheTotalEdgeCost, ()) {
  const auto nodes = *rc::gen::inRange<std::int32_t>(1, 7);
  const Problem problem = arbitrary_problem(nodes, 3);
  const Labels start(static_cast<std::size_t>(nodes), 2);
  const Labels labels = alpha_expansion(problem.costs, problem.edges, start);
  const double cost = labelling_cost(labels, problem.costs, problem.edges);
  const double least = min_cost(problem);
  // Boykov, Veksler, Zabih 2001, theorem 6.1: the edges that the best labelling cuts count at most twice.
  double all_edges = 0;
  for (const LabelEdge& edge : problem.edges) all_edges += edge.cost;
  RC_ASSERT(cost >= least);
  RC_ASSERT(cost <= least + all_edges);
  RC_ASSERT(cost <= labelling_cost(start, problem.costs, problem.edges));
}

TEST(AlphaExpansion, GivesNodesLinkedByStrongEdgesTheSameLabel) {
  const Eigen::MatrixXd costs{
      {0, 5}, {2, 0}, {0, 2}, {5, 0}};  // the data terms of the two in the middle favour the opposite labels
  std::vector<LabelEdge> edges = {{0, 1, 3}, {1, 2, 0.5}, {2, 3, 3}};
  EXPECT_EQ(alpha_expansion(costs, edges, {0, 0, 0, 0}), (Labels{0, 0, 1, 1}));
  for (LabelEdge& edge : edges) edge.cost = 0.1;
  EXPECT_EQ(alpha_expansion(costs, edges, {0, 0, 0, 0}), (Labels{0, 1, 0, 1}));
}

TEST(AlphaExpansion, DoesNotDependOnTheDirectionOfEdges) {
  // The data term of one node favours the first label by 2, the other must have the second; the edge costs 3.
  const Eigen::MatrixXd costs{{0, 2}, {10, 0}};
  EXPECT_EQ(alpha_expansion(costs, {{0, 1, 3}}, {0, 1}), (Labels{1, 1}));
  EXPECT_EQ(alpha_expansion(costs, {{1, 0, 3}}, {0, 1}), (Labels{1, 1}));
}

TEST(AlphaExpansion, RejectsNanCostsNegativeWeightsAndIndicesOutOfRange) {
  const Eigen::MatrixXd costs = Eigen::MatrixXd::Zero(2, 2);
  EXPECT_THROW(alpha_expansion(costs, {}, {0}), ArgumentError);
  EXPECT_THROW(alpha_expansion(costs, {}, {0, 2}), ArgumentError);
  EXPECT_THROW(alpha_expansion(costs, {{0, 2, 1}}, {0, 0}), ArgumentError);
  EXPECT_THROW(alpha_expansion(costs, {{0, 1, -1}}, {0, 0}), ArgumentError);
  EXPECT_THROW(alpha_expansion(Eigen::MatrixXd::Constant(2, 2, NAN), {}, {0, 0}), ArgumentError);
}

TEST(AlphaExpansion, RepeatsRoundsWhileTheCostFalls) {
  const Eigen::MatrixXd costs{{6, 0, 3}, {0, 4, 1}};
  EXPECT_EQ(alpha_expansion(costs, {{0, 1, 1}}, {2, 2}), (Labels{1, 0})) << "the second round changes node 1";
}

}  // namespace
}  // namespace shapegauge
