// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Include <maxflow.h> before CGAL, which includes this header inside of a namespace.

/// Max-flow graph for CGAL's alpha-expansion, computed by Debian's libmaxflow. Replaces CGAL's own copy of that
/// library, which reuses the flow of one expansion for the next: this is fast but gives wrong cuts.
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
