// SPDX-License-Identifier: GPL-3.0-or-later
// make_sample_reports FOLDER: writes the sample reports, a leaderboard and a multi-dataset page, for a browser to
// open.
#include <filesystem>
#include <iostream>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/pages/leaderboard_page.h"
#include "shapegauge/pages/multi_dataset_page.h"
#include "shapegauge/pages/report.h"
#include "tests/pages/sample_leaderboard.h"
#include "tests/pages/sample_multi_dataset.h"
#include "tests/pages/sample_reports.h"

int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    std::cerr << "usage: make_sample_reports FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  using namespace shapegauge;
  write_file_atomically(folder / "hostile.html", report_page(test_report::hostile_report().report));
  write_file_atomically(folder / "plain.html", report_page(test_report::plain_report().report));
  write_file_atomically(folder / "crowded.html", report_page(test_report::crowded_report().report));
  write_file_atomically(folder / "leaderboard.html", leaderboard_page(test_leaderboard::sample_leaderboard().page));
  write_file_atomically(folder / "multi_dataset.html", multi_dataset_page(test_multi_dataset::sample_multi_dataset()));
  return 0;
}
