#include "shapegauge/experiments/text/quoted_word.h"

#include "shapegauge/core/printable.h"

namespace shapegauge {

std::string quoted_word(std::string_view word) { return '"' + printable(word, 40) + '"'; }

}  // namespace shapegauge
