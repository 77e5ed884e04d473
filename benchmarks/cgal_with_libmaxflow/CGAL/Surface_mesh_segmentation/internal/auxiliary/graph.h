// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// CGAL includes this inside of a namespace, so that <maxflow.h> must have been included before.

/// Debian's libmaxflow under the name by which CGAL's alpha-expansion knows its own copy, which keeps the flow of one
/// expansion for the next: that makes it fast and its cuts wrong.
class Graph {
 public:
  using node_id = int;
  enum termtype { SOURCE, SINK };

  node_id add_node() { return flow_.add_node(1); }
  void add_tweights(node_id node, double source, double sink) { flow_.add_tweights(node, source, sink); }
  void add_edge(node_id from, node_id to, double there, double back) { flow_.add_edge(from, to, there, back); }
  double maxflow() { return flow_.maxflow(); }
  void clear() { flow_.reset(); }
  termtype what_segment(node_id node) { return flow_.what_segment(node, Flow::SINK) == Flow::SOURCE ? SOURCE : SINK; }

 private:
  using Flow = maxflow::Graph<double, double, double>;
  Flow flow_{1000, 4000};
};
