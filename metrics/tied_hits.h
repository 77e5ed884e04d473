#pragma once

#include <cstddef>
#include <vector>

namespace shapegauge {

/// Appends, for each of `hits` relevant models among `size` consecutive ranks in open order, the mean of k / rank of
/// the k-th hit of the list: k counts on from the precisions that are there, ranks from `ranks_before`.
///
/// In all orders of n ranks with m hits, the j-th hit is at the t-th of them with the probability
/// C(t-1, j-1) C(n-t, m-j) / C(n, m) (negative hypergeometric); the mean is the sum over t, with terms below 1e-18 of
/// the largest one left out.
void append_precisions(std::vector<double>& precisions, std::size_t size, std::size_t hits, std::size_t ranks_before);

}  // namespace shapegauge
