#include "app/today.h"

#include <ctime>

namespace torrance {

std::string today()
{
    const std::time_t now = std::time(nullptr);
    char text[16];
    std::strftime(text, sizeof text, "%F", std::gmtime(&now));
    return text;
}

} // namespace torrance
