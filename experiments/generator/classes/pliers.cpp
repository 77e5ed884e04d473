#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

Skeleton pliers() {
  Skeleton s{"pliers", {}};
  const int pivot = add_limb(s, {.kind = "pivot", .nodes = {{{-0.1, 0, 0}, 0.2}, {{0.1, 0, 0}, 0.2}}, .flatness = 0.6});
  add_limb_pair(
      s, {.kind = "jaw",
          .parent = pivot,
          .nodes = {{{0.15, 0.1, 0}, 0.14}, {{0.4, 0.15, 0}, 0.12}, {{0.65, 0.14, 0}, 0.095}, {{0.92, 0.11, 0}, 0.06}},
          .joints = {{0, {yaw(-3, 28)}}},
          .blend = 0.3,
          .flatness = 0.8});
  add_limb_pair(s, {.kind = "handle",
                    .parent = pivot,
                    .nodes = {{{-0.12, 0.1, 0}, 0.11},
                              {{-0.4, 0.26, 0}, 0.095},
                              {{-0.8, 0.36, 0}, 0.1},
                              {{-1.2, 0.36, 0}, 0.1},
                              {{-1.55, 0.3, 0}, 0.085}},
                    .joints = {{0, {yaw(-30, 9)}}, {2, {yaw(-6, 6)}}},
                    .flatness = 0.75});
  return s;
}

}  // namespace shapegauge
