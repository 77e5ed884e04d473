// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/generator/object_classes.h"

#include <array>

#include "shapegauge/datasets/generator/drawn_objects.h"

namespace shapegauge {

namespace {

const std::array classes = {
    ObjectClass{"mug", {"vessel", "handle", "other handle"}, &draw_mug},
    ObjectClass{"table",
                {"top", "leg 1", "leg 2", "leg 3", "leg 4", "column", "foot 1", "foot 2", "foot 3", "foot 4", "foot 5"},
                &draw_table},
    ObjectClass{"aeroplane",
                {"fuselage", "wing right", "wing left", "tailplane right", "tailplane left", "fin",
                 "inner engine right", "inner engine left", "outer engine right", "outer engine left"},
                &draw_aeroplane},
    ObjectClass{"vase", {"body", "neck", "foot", "handle", "other handle"}, &draw_vase},
    ObjectClass{"chair",
                {"seat", "back", "leg 1", "leg 2", "leg 3", "leg 4", "arm right", "arm left", "column", "foot 1",
                 "foot 2", "foot 3", "foot 4", "foot 5"},
                &draw_chair},
    ObjectClass{"spectacles", {"lens right", "lens left", "temple right", "temple left", "bridge"}, &draw_spectacles},
    ObjectClass{"shaft", {"piece 1", "piece 2", "piece 3", "piece 4"}, &draw_shaft},
    ObjectClass{
        "fish", {"body", "tail fin", "dorsal fin", "pectoral fin right", "pectoral fin left", "anal fin"}, &draw_fish},
    ObjectClass{"teapot", {"body", "spout", "handle", "knob"}, &draw_teapot},
    ObjectClass{"bracket", {"base", "plate", "boss", "other boss"}, &draw_bracket},
    ObjectClass{"bust", {"torso", "neck", "head", "pedestal"}, &draw_bust},
    ObjectClass{"hammer", {"handle", "head", "claw"}, &draw_hammer}};

}  // namespace

std::span<const ObjectClass> object_classes() { return classes; }

}  // namespace shapegauge
