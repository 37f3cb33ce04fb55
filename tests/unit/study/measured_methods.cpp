#include "study/measured_methods.h"

#include "core/error.h"
#include "study/stability_atlas.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace torrance {
namespace {

TEST(MeasuredMethods, AreReadBackAsTheyWereWritten)
{
    const std::vector<MeasuredMethod> written = {
        {.method = "fresnel/a",
         .fp32 = 1.25e-7,
         .fp16 = HUGE_VAL,
         .models = "b 1 (rms 0.5); c 2, or so",
         .energy = 0.5},
        {.method = "fresnel/b", .fp32 = {}, .fp16 = 0.5, .models = "", .energy = 0}};
    const std::vector<MeasuredMethod> read = readMeasured(measuredCsv(written), "t.csv");
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0].fp32, 1.25e-7);
    EXPECT_EQ(read[0].fp16, HUGE_VAL);
    EXPECT_EQ(read[0].models, written[0].models);
    EXPECT_EQ(read[0].energy, 0.5);
    EXPECT_FALSE(read[1].fp32);
    EXPECT_EQ(read[1].fp16, 0.5);
}

TEST(MeasuredMethods, RefuseWhatIsNoTableOfThem)
{
    EXPECT_THROW(readMeasured("method,fp32\na,1\n", "t.csv"), Error);
    EXPECT_THROW(readMeasured("method,fp32,fp16,models,energy\na,much,1,,1\n", "t.csv"), Error);
}

// The stored table is of the registry as it is: torrance stability --table docs/measured.csv
TEST(MeasuredMethods, TheStoredTableNamesEveryMethodThatCanBeSwept)
{
    std::ostringstream text;
    text << std::ifstream(TORRANCE_SOURCE_DIR "/docs/measured.csv").rdbuf();
    std::vector<std::string> stored, swept;
    for (const MeasuredMethod& measured : readMeasured(text.str(), "docs/measured.csv"))
        stored.push_back(measured.method);
    for (const brdf::Method& method : brdf::allMethods())
        if (canSweep(method))
            swept.push_back(methodName(method));
    EXPECT_EQ(stored, swept) << "run: torrance stability --table docs/measured.csv";
}

} // namespace
} // namespace torrance
