#include "brdf/slot_option.h"

#include <algorithm>

namespace torrance::brdf {

std::string slotWord(Slot slot)
{
    std::string name(slotName(slot));
    std::ranges::replace(name, '_', '-');
    return name;
}

std::string slotOption(Slot slot)
{
    return "--" + slotWord(slot);
}

} // namespace torrance::brdf
