#include "make_assets/chart_atlas.h"

#include <algorithm>
#include <stdexcept>

namespace torrance::assets {
namespace {

constexpr int kChartGap = 2; // so that a bilinear footprint of the first mip level stays inside

struct Request
{
    std::size_t object;
    std::size_t part;
    int width;
    int height;
};

std::vector<Request> requestsByHeight(const std::vector<DemoObject>& objects)
{
    std::vector<Request> requests;
    for (std::size_t i = 0; i < objects.size(); ++i)
        for (std::size_t j = 0; j < objects[i].parts.size(); ++j)
            requests.push_back({i, j, objects[i].parts[j].chartWidth, objects[i].parts[j].chartHeight});
    std::stable_sort(requests.begin(), requests.end(),
                     [](const Request& a, const Request& b) { return a.height > b.height; });
    return requests;
}

} // namespace

std::vector<std::vector<Chart>> layOutCharts(const std::vector<DemoObject>& objects)
{
    std::vector<std::vector<Chart>> charts(objects.size());
    for (std::size_t i = 0; i < objects.size(); ++i)
        charts[i].resize(objects[i].parts.size());

    // Shelves: the tallest charts first, side by side, then the next shelf below.
    int x = 0;
    int y = 0;
    int shelf = 0;
    for (const Request& request : requestsByHeight(objects)) {
        if (x + request.width > kAtlasSize) {
            x = 0;
            y += shelf + kChartGap;
            shelf = 0;
        }
        if (y + request.height > kAtlasSize)
            throw std::runtime_error("the occlusion atlas is too small for the demo scene's charts");
        charts[request.object][request.part] = {x, y, request.width, request.height};
        x += request.width + kChartGap;
        shelf = std::max(shelf, request.height);
    }
    return charts;
}

} // namespace torrance::assets
