// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/pages/page_constants.h"

namespace shapegauge {
namespace {

TEST(PageConstants, AreTheSameInTheProgramAndThePageScripts) {
  EXPECT_EQ(read_file_bytes(SHAPEGAUGE_SOURCE_FOLDER "/pages/common/constants.mjs"), page_constants_script())
      << "to write the file anew, build the target update_page_constants";
}

}  // namespace
}  // namespace shapegauge
