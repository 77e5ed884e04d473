#pragma once

namespace shapegauge {

/// Points are put onto the offset surface at r (1 + offset_slack), and count as outside of the offset solid from r on.
inline constexpr double offset_slack = 1e-4;

}  // namespace shapegauge
