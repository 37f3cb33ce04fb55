// `torrance compare`: what it measures is tested in unit/measure; here, that it says and does it.
#include "files/image_write.h"
#include "program.h"

#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace torrance::test {
namespace {

class Compare : public ::testing::Test
{
protected:
    std::string picture(const std::string& name, const Image& image)
    {
        writePicture(folder.file(name), image, {}, {.tone = findToneCurve("none")});
        return folder.file(name);
    }

    TestFolder folder;
    Image grey = Image(24, 16, 3, 0.25f);
    Image lighter = Image(24, 16, 3, 0.5f);
};

TEST_F(Compare, EqualPicturesPassEveryLimit)
{
    for (const char* name : {"a.png", "a.webp", "a.exr", "a.hdr"}) {
        const std::string path = picture(name, grey);
        const Outcome outcome = runTorrance({"compare", path, path, "--max-rmse", "0", "--max-relmse=0", "--max-smape",
                                             "0", "--max-flip", "0", "--max-flip-p99", "0", "--max-pixel-error", "0",
                                             "--max-alpha", "0", "--max-non-finite", "0"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        EXPECT_NE(outcome.output.find("RMSE"), std::string::npos);
        EXPECT_EQ(outcome.errors, "");
    }
}

TEST_F(Compare, MeasuresInLinearLight)
{
    // EXR holds the floats: 0.5 - 0.25. PNG holds their sRGB codes, rounded to a 255th, where the curve's slope is
    // below 2.
    for (const auto& [extension, tolerance] : {std::pair(".exr", 1e-7), std::pair(".png", 1.0 / 255)}) {
        const std::string reference = picture(std::string("a") + extension, grey);
        const std::string test = picture(std::string("b") + extension, lighter);
        const Outcome outcome = runTorrance({"compare", "--json", "-", reference, test});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        const nlohmann::json result = nlohmann::json::parse(outcome.output);
        EXPECT_NEAR(result["rmse"].get<double>(), 0.25, tolerance);
        EXPECT_EQ(result["flip_kind"], std::string(extension) == ".png" ? "LDR" : "HDR");
        EXPECT_TRUE(result["passed"].get<bool>());
    }
}

TEST_F(Compare, ExceededLimitsAreExitCodeOneAndOneLine)
{
    const std::string reference = picture("a.png", grey), test = picture("b.png", lighter);
    const Outcome outcome = runTorrance({"compare", reference, test, "--max-rmse", "0.1", "--max-flip", "0.001"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    EXPECT_NE(outcome.errors.find("RMSE"), std::string::npos) << outcome.errors;
    EXPECT_NE(outcome.errors.find("mean FLIP"), std::string::npos) << outcome.errors;
    EXPECT_EQ(runTorrance({"compare", reference, test, "--max-rmse", "0.3"}).exitCode, 0);
}

TEST_F(Compare, OptionsMayStandAnywhere)
{
    const std::string reference = picture("a.png", grey), test = picture("b.png", lighter);
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"compare", "--max-rmse", "0.1", reference, test, "--quiet"},
          std::vector<std::string>{"--quiet", "compare", reference, "--max-rmse", "0.1", test},
          std::vector<std::string>{"compare", reference, test, "--quiet", "--max-rmse=0.1"},
          std::vector<std::string>{"--max-rmse", "0.1", reference, "--quiet", "compare", test}})
    {
        const Outcome outcome = runTorrance(arguments);
        EXPECT_EQ(outcome.exitCode, 1) << outcome.errors;
        EXPECT_EQ(outcome.output, "") << "--quiet";
    }
}

TEST_F(Compare, NonFinitePixelsFailUnlessAllowed)
{
    Image broken = grey;
    broken.texels[5] = std::numeric_limits<float>::quiet_NaN();
    const std::string reference = picture("a.exr", grey), test = picture("b.exr", broken);
    const Outcome outcome = runTorrance({"compare", reference, test});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.errors.find("non-finite"), std::string::npos) << outcome.errors;
    EXPECT_EQ(runTorrance({"compare", reference, test, "--max-non-finite", "1"}).exitCode, 0);
}

TEST_F(Compare, WritesTheHeatMapAndTheJsonFileEvenWhenItFails)
{
    const std::string reference = picture("a.png", grey), test = picture("b.png", lighter);
    const Outcome outcome = runTorrance({"compare", reference, test, "--max-rmse", "0", "--heat-map",
                                         folder.file("heat.png"), "--json", folder.file("result.json")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.png", "b.png", "heat.png", "result.json"}));
    std::ifstream file(folder.file("result.json"));
    EXPECT_FALSE(nlohmann::json::parse(file)["passed"].get<bool>());
    EXPECT_EQ(runTorrance({"compare", reference, folder.file("heat.png")}).exitCode, 0) << "of the same size";
}

TEST_F(Compare, RefusesPicturesOfDifferentSizeOrKind)
{
    const std::string reference = picture("a.png", grey);
    const Outcome size = runTorrance({"compare", reference, picture("b.png", Image(8, 8, 3))});
    EXPECT_EQ(size.exitCode, 3);
    EXPECT_TRUE(isOneLine(size.errors)) << size.errors;
    EXPECT_NE(size.errors.find("8x8"), std::string::npos) << size.errors;
    EXPECT_EQ(runTorrance({"compare", reference, picture("b.exr", grey)}).exitCode, 3);
}

TEST_F(Compare, RefusesBadFilesByName)
{
    const std::string reference = picture("a.png", grey);
    const std::string garbage = folder.file("garbage.png"), empty = folder.file("empty.png");
    std::ofstream(garbage) << "neither fish nor fowl";
    std::ofstream(empty).close();
    for (const std::string& bad : {garbage, empty, folder.path.string(), folder.file("missing.png")}) {
        const Outcome outcome = runTorrance({"compare", reference, bad, "--heat-map", folder.file("heat.png")});
        EXPECT_EQ(outcome.exitCode, 3);
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
        EXPECT_NE(outcome.errors.find(bad), std::string::npos) << outcome.errors;
    }
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.png", "empty.png", "garbage.png"}));
}

TEST_F(Compare, SaysWhereItCannotWrite)
{
    const std::string reference = picture("a.png", grey);
    for (const std::string& place : {folder.file("missing/heat.png"), folder.file("missing/result.json")}) {
        const std::string option = place.ends_with(".json") ? "--json" : "--heat-map";
        const Outcome outcome = runTorrance({"compare", reference, reference, option, place});
        EXPECT_EQ(outcome.exitCode, 6);
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    }
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.png"}));
}

TEST_F(Compare, BadUsageIsExitCodeTwo)
{
    const std::string path = picture("a.png", grey);
    for (const std::vector<std::string>& rest :
         {std::vector<std::string>{"--max-rmse", "-1"}, std::vector<std::string>{"--max-rmse", "nan"},
          std::vector<std::string>{"--max-rmse", "much"}, std::vector<std::string>{"--max-rmse"},
          std::vector<std::string>{"--max-rmse", "1", "--max-rmse", "2"},
          std::vector<std::string>{"--heat-map", "a.txt"}, std::vector<std::string>{"--heat-map", "a.exr"},
          std::vector<std::string>{"third.png"}, std::vector<std::string>{"--quiet", "--verbose"}})
    {
        std::vector<std::string> arguments = {"compare", path, path};
        arguments.insert(arguments.end(), rest.begin(), rest.end());
        const Outcome outcome = runTorrance(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << rest.back();
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    }
}

TEST_F(Compare, SuggestsTheNearestOptionAndCommand)
{
    const std::string path = picture("a.png", grey);
    const Outcome option = runTorrance({"compare", path, path, "--max-rmes", "1"});
    EXPECT_EQ(option.exitCode, 2);
    EXPECT_NE(option.errors.find("did you mean --max-rmse?"), std::string::npos) << option.errors;
    const Outcome command = runTorrance({"comapre", path, path});
    EXPECT_EQ(command.exitCode, 2);
    EXPECT_NE(command.errors.find("did you mean compare?"), std::string::npos) << command.errors;
}

} // namespace
} // namespace torrance::test
