// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// Embeds models in the plane by their distances, models x models: classical multidimensional scaling (Torgerson 1952).
/// The largest finite distance replaces infinite ones; d(i, j) and d(j, i) are averaged. The result has one row per
/// model, is centred, and has the longer axis first; the largest coordinate of each axis by magnitude is positive.
/// Models without finite distances have NaN.
Eigen::MatrixX2d plane_embedding(const Eigen::MatrixXd& distances);

}  // namespace shapegauge
