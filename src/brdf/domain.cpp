#include "brdf/method.h"

#include <fmt/format.h>

namespace torrance::brdf {

std::string domainText(const Domain& domain)
{
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
    if (domain.leastRoughness > 0.0)
        add(fmt::format("roughness >= {}", domain.leastRoughness));
    if (domain.greatestRoughness < 1.0)
        add(fmt::format("roughness <= {}", domain.greatestRoughness));
    if (domain.leastCosine > 0.0)
        add(fmt::format("NoV, NoL >= {}", domain.leastCosine));
    if (domain.leastIor > 0.0)
        add(fmt::format("ior >= {}", domain.leastIor));
    if (domain.text != "all" || text.empty())
        add(std::string(domain.text));
    return text;
}

} // namespace torrance::brdf
