#include <cstdlib>
#include <gmock/gmock.h>
#include <optional>
#include <string>

#include "shapegauge/experiments/cache/cache_folder.h"
#include "tests/experiments/input_error.h"

namespace shapegauge {
namespace {

using testing::HasSubstr;

/// While it lives, an environment variable has a value, or none.
class Variable {
 public:
  Variable(const char* name, const std::optional<std::string>& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    set(value);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  Variable(Variable&&) = delete;
  Variable& operator=(Variable&&) = delete;
  ~Variable() { set(before_); }

 private:
  void set(const std::optional<std::string>& value) const {
    if (value) {
      ::setenv(name_, value->c_str(), 1);
    } else {
      ::unsetenv(name_);
    }
  }

  const char* name_;
  std::optional<std::string> before_;
};

TEST(CacheFolder, IsTheOneNamedOrThatOfTheSpecification) {
  const Variable home("HOME", "/home/someone");
  const Variable xdg("XDG_CACHE_HOME", std::nullopt);
  const Variable named("SHAPEGAUGE_CACHE", std::nullopt);
  EXPECT_EQ(default_cache_folder(), "/home/someone/.cache/shapegauge");
  {
    const Variable elsewhere("XDG_CACHE_HOME", "/var/caches");
    EXPECT_EQ(default_cache_folder(), "/var/caches/shapegauge");
    const Variable own("SHAPEGAUGE_CACHE", "here");
    EXPECT_EQ(default_cache_folder(), "here");
    const Variable none("SHAPEGAUGE_CACHE", "");
    EXPECT_EQ(default_cache_folder(), "");
  }
  const Variable relative("XDG_CACHE_HOME", "caches");
  EXPECT_EQ(default_cache_folder(), "/home/someone/.cache/shapegauge") << "a relative one does not count";
  const Variable homeless("HOME", std::nullopt);
  EXPECT_EQ(default_cache_folder(), "");
}

TEST(CacheFolder, SizesHaveUnits) {
  EXPECT_EQ(parse_size("0", "x"), 0U);
  EXPECT_EQ(parse_size("123", "x"), 123U);
  EXPECT_EQ(parse_size("5K", "x"), 5000U);
  EXPECT_EQ(parse_size("20M", "x"), 20'000'000U);
  EXPECT_EQ(parse_size("3G", "x"), 3'000'000'000U);
  EXPECT_EQ(parse_size("2T", "x"), 2'000'000'000'000U);
  for (const char* wrong :
       {"", "G", "-1", "1.5G", "10 G", "10GB", "10g", "18446744073709551615K", "99999999999999999999"}) {
    EXPECT_THAT(input_error_of([&] { parse_size(wrong, "LIMIT"); }), HasSubstr("LIMIT must be a size")) << wrong;
  }
}

TEST(CacheFolder, TheLimitIsThatOfTheVariable) {
  const Variable unset("SHAPEGAUGE_CACHE_LIMIT", std::nullopt);
  EXPECT_EQ(cache_limit(), 10'000'000'000U);
  const Variable set("SHAPEGAUGE_CACHE_LIMIT", "1M");
  EXPECT_EQ(cache_limit(), 1'000'000U);
}

}  // namespace
}  // namespace shapegauge
