// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <string>

#include "shapegauge/experiments/leaderboard/judge_submissions.h"
#include "tests/support/test_files.h"

namespace shapegauge::test_board {

inline constexpr int models = 12;

/// A table of twelve models in three classes.
inline std::string small_labels() {
  std::string text = "id,class\n";
  for (int i = 0; i < models; ++i) text += fmt::format("m{},{}\n", i, std::string(1, static_cast<char>('a' + i % 3)));
  return text;
}

/// CSV matrix without ids in which models of a class are close, with errors of up to `noise`.
inline std::string small_matrix(double noise, double sign = 1) {
  std::string text;
  for (int i = 0; i < models; ++i) {
    for (int j = 0; j < models; ++j) {
      const double wild = std::sin(12.9898 * (i * models + j)) * 43758.5453;
      const double distance = (i % 3 == j % 3 ? 1 : 2) + noise * (wild - std::floor(wild));
      text += fmt::format("{}{}", j > 0 ? "," : "", i == j ? 0.0 : sign * distance);
    }
    text += "\n";
  }
  return text;
}

/// Folder with labels and two submissions: "good" is perfect, "poor" is not.
struct SmallBoard {
  SmallBoard() {
    std::filesystem::create_directories(submissions());
    test::write_text(labels(), small_labels());
    test::write_text(submissions() / "good.csv", small_matrix(0));
    test::write_text(submissions() / "poor.csv", small_matrix(3));
  }
  [[nodiscard]] std::filesystem::path labels() const { return folder.path() / "labels.csv"; }
  [[nodiscard]] std::filesystem::path submissions() const { return folder.path() / "submissions"; }
  void add(const std::string& name, const std::string& text) const { test::write_text(submissions() / name, text); }
  [[nodiscard]] JudgingOptions options() const {
    JudgingOptions options;
    options.files.labels = labels();
    options.standings.resampling.resamples = 200;
    return options;
  }
  [[nodiscard]] FoundSubmissions found() const { return find_submissions(std::vector{submissions()}); }
  [[nodiscard]] Leaderboard judged(Cache& cache) const { return judge_submissions(found(), options(), cache); }
  [[nodiscard]] Leaderboard judged() const {
    Cache none;
    return judged(none);
  }
  test::TemporaryFolder folder;
};

}  // namespace shapegauge::test_board
