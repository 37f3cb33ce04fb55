#include "brdf/slot_option.h"

#include <algorithm>

namespace torrance::brdf {

std::string slotOption(Slot slot)
{
    std::string name = "--" + std::string(slotName(slot));
    std::ranges::replace(name, '_', '-');
    return name;
}

} // namespace torrance::brdf
