#include "app/chart_output.h"

#include "core/atomic_write.h"
#include "core/data_folder.h"
#include "core/log.h"
#include "core/read_file.h"

namespace torrance {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file)
{
    const std::vector<std::byte> bytes = readFile(file.string());
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace

void writeChart(const fs::path& folder, const std::string& name, const ChartPage& page)
{
    writeFile(folder / (name + ".svg"), chartSvg(page));
    const fs::path data = dataFolder() / "chart";
    if (!fs::exists(data / "vega.js")) {
        logWarning("no " + name + ".html: Torrance was built without Vega (Debian package libjs-vega)");
        return;
    }
    const ChartScripts scripts = {
        .vega = textOf(data / "vega.js"), .page = textOf(data / "page.js"), .style = textOf(data / "page.css")};
    writeFile(folder / (name + ".html"), chartHtml(page, scripts));
}

} // namespace torrance
