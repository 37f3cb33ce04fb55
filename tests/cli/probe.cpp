// torrance probe: columns, terms and what is wrong with a table. The values themselves are held in
// tests/gpu/brdf_terms.cpp.
#include "program.h"

#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace torrance::test {
namespace {

const std::string kHeader = "id,nx,ny,nz,vx,vy,vz,lx,ly,lz,roughness,metallic,base_r,base_g,base_b,ior,eta,k\n";
const std::string kRow = "a,0,0,2,0,0,1,0,0,3,1,0,0.5,0.25,1,1.5,0.2,3.9\n";

class Probe : public testing::Test
{
protected:
    Outcome probe(const std::string& csv, std::vector<std::string> arguments)
    {
        std::ofstream(folder.file("rows.csv")) << csv;
        arguments.insert(arguments.begin(), "probe");
        arguments.insert(arguments.end(), {"--input", folder.file("rows.csv")});
        return runTorrance(arguments);
    }

    void refuses(const std::string& csv, const std::vector<std::string>& arguments, int exitCode,
                 const std::string& words)
    {
        const Outcome outcome = probe(csv, arguments);
        EXPECT_EQ(outcome.exitCode, exitCode) << outcome.errors;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
        EXPECT_NE(outcome.errors.find(words), std::string::npos) << outcome.errors;
        EXPECT_EQ(outcome.output, "");
    }

    TestFolder folder;
};

// The cells of the second line.
std::vector<double> firstRow(const std::string& csv)
{
    std::istringstream lines(csv);
    std::string line, cell;
    std::getline(lines, line);
    EXPECT_EQ(line, "id,device_r,device_g,device_b,cpu_r,cpu_g,cpu_b,rel,kappa");
    std::getline(lines, line);
    std::istringstream cells(line);
    std::vector<double> values;
    std::getline(cells, cell, ',');
    while (std::getline(cells, cell, ','))
        values.push_back(std::stod(cell));
    return values;
}

// n = v = l, alpha = 1: D = 1/pi, V = 1/4, so glTF's dielectric is 0.96 base/pi + 0.04/(4 pi).
TEST_F(Probe, PrintsDeviceAndProcessorSideBySide)
{
    const double pi = 3.14159265358979323846;
    const Outcome outcome = probe(kHeader + kRow, {"--term", "brdf", "--preset", "gltf"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const std::vector<double> row = firstRow(outcome.output);
    ASSERT_EQ(row.size(), 8u) << outcome.output;
    const double base[] = {0.5, 0.25, 1.0};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const double expected = 0.96 * base[channel] / pi + 0.01 / pi;
        EXPECT_NEAR(row[channel] / expected, 1.0, 1e-6);
        EXPECT_NEAR(row[channel + 3] / expected, 1.0, 1e-14);
    }
    EXPECT_LE(row[6], 1e-6);
}

TEST_F(Probe, ScalarsStandInAllThreeColumns)
{
    const Outcome outcome = probe(kHeader + kRow, {"--term", "distribution"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const std::vector<double> row = firstRow(outcome.output);
    EXPECT_EQ(row[0], row[2]);
    EXPECT_EQ(row[3], row[5]);
    EXPECT_NEAR(row[3], 1 / 3.14159265358979323846, 1e-15);
}

TEST_F(Probe, KnowsEveryTermThatHasAFormula)
{
    for (const char* term : {"distribution", "visibility", "fresnel", "diffuse", "diffuse_weight",
                             "multiple_scattering", "dfg", "albedo", "brdf"})
    {
        const Outcome outcome = probe(kHeader + kRow, {"--term", term});
        EXPECT_EQ(outcome.exitCode, 0) << term << ": " << outcome.errors;
        EXPECT_EQ(firstRow(outcome.output).size(), 8u) << outcome.output;
    }
}

// n = v = l: the peak 1 / (pi alphaT alphaB), alphaB = 0.5^2 and alphaT = 0.25 + 0.75 * 0.6^2 = 0.52
// (KHR_materials_anisotropy).
TEST_F(Probe, ReadsATangentAndAnisotropyWhereTheMethodDoes)
{
    const std::string header = "id,nx,ny,nz,vx,vy,vz,lx,ly,lz,roughness,tx,ty,tz,anisotropy\n";
    const std::vector<std::string> term = {"--term", "distribution", "--method", "ggx_aniso"};
    const Outcome outcome = probe(header + "a,0,0,1,0,0,1,0,0,1,0.5,1,0,7,0.6\n", term);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const std::vector<double> row = firstRow(outcome.output);
    EXPECT_NEAR(row[3] * 3.14159265358979323846 * 0.25 * 0.52, 1.0, 1e-14);
    EXPECT_LE(row[6], 5e-6);
    refuses(header + "a,0,0,1,0,0,1,0,0,1,0.5,0,0,-2,0.6\n", term, 3, "lies along the normal");
}

TEST_F(Probe, WritesFilesWholeAndASummary)
{
    const Outcome outcome = probe(kHeader + kRow + kRow, {"--term", "fresnel", "--method", "exact_conductor", "-o",
                                                          folder.file("out.csv"), "--json", folder.file("out.json")});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(firstRow(contentOf(folder.file("out.csv"))).size(), 8u);
    EXPECT_NE(contentOf(folder.file("out.json")).find("\"rows\": 2"), std::string::npos);
}

TEST_F(Probe, SameTableGivesTheSameBytes)
{
    const std::string table = kHeader + kRow + "b,0.1,0.2,0.9,0.5,0,1,-0.4,0.2,0.7,0.3,0.5,0.5,0.25,1,1.5,0.2,3.9\n";
    EXPECT_EQ(probe(table, {"--term", "brdf"}).output, probe(table, {"--term", "brdf"}).output);
}

TEST_F(Probe, NeedsOnlyTheColumnsThatTheTermReads)
{
    const std::string small = "id,nx,ny,nz,vx,vy,vz,lx,ly,lz,roughness\na,0,0,1,0,0,1,0,0,1,0.5\n";
    EXPECT_EQ(probe(small, {"--term", "visibility", "--method", "hammon"}).exitCode, 0);
    refuses(small, {"--term", "brdf"}, 3, "column base_r: is missing");
    refuses(small, {"--term", "fresnel", "--method", "exact_dielectric"}, 3, "column ior: is missing");
    refuses(small, {"--term", "fresnel", "--method", "lazanyi"}, 3, "column eta: is missing");
    refuses(small, {"--term", "fresnel", "--method", "f82"}, 3, "column f82_r: is missing");
    refuses(small, {"--term", "distribution", "--method", "ggx_aniso"}, 3, "column tx: is missing");
}

TEST_F(Probe, WarnsOfVectorsThatAreNotUnit)
{
    const auto said = [&](const std::string& vectors) {
        return probe(kHeader + "b," + vectors + ",0.5,0,0.5,0.25,1,1.5,0.2,3.9\n", {"--term", "brdf"}).errors;
    };
    EXPECT_EQ(said("0,0,1,0,0.6,0.8,0,-0.6,0.8"), "");
    EXPECT_EQ(said("0,0,1,0,0.707,0.707,0,-0.6,0.8"), "") << "three digits";
    EXPECT_NE(said("0,0,1,0,3,4,0,-0.6,0.8").find("line 2, column vx vy vz: is not of length 1"), std::string::npos);
}

TEST_F(Probe, VectorsOfAnyLengthAreNormalised)
{
    const auto values = [&](const std::string& vectors) {
        const Outcome outcome = probe(kHeader + "a," + vectors + ",0.5,0,0.5,0.25,1,1.5,0.2,3.9\n", {"--term", "brdf"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        return firstRow(outcome.output);
    };
    const std::vector<double> unit = values("0,0,1,0,0.6,0.8,0,-0.6,0.8");
    for (const char* vectors : {"0,0,7,0,3,4,0,-3,4", "0,0,1e-300,0,3e-200,4e-200,0,-3e300,4e300"}) {
        const std::vector<double> other = values(vectors);
        for (std::size_t i = 0; i < 6; ++i) // device and processor; their difference is rounding
            EXPECT_NEAR(other.at(i), unit.at(i), 1e-6 * unit.at(i)) << vectors;
    }
}

TEST_F(Probe, NamesWhatIsWrongWithATable)
{
    const std::vector<std::string> term = {"--term", "brdf"};
    refuses("", term, 3, "is empty");
    refuses("id,nx\n", term, 3, "column ny: is missing");
    refuses(kHeader + "a,0,0,1,0,0,1,0,0,1,nan,0,1,1,1,1,1,1\n", term, 3, "line 2, column roughness");
    refuses(kHeader + "a,0,0,1,0,0,1,0,0,1,1.5,0,1,1,1,1,1,1\n", term, 3, "1.5 is outside [0, 1]");
    refuses(kHeader + "a,0,0,1,0,0,1,0,0,x,1,0,1,1,1,1,1,1\n", term, 3,
            "line 2, column lz: 'x' is not a finite number");
    refuses(kHeader + kRow + "a,0,0,0,0,0,1,0,0,1,1,0,1,1,1,1,1,1\n", term, 3,
            "line 3, column nx ny nz: is a vector of zero length");
    refuses(kHeader + "a,0,0,1,0,0,1,0,0,inf,1,0,1,1,1,1,1,1\n", term, 3, "line 2, column lz");
    refuses(kHeader + "a,0,0,1,0,0,1,0,0,1,-0.1,0,1,1,1,1,1,1\n", term, 3, "-0.1 is outside [0, 1]");
    refuses(kHeader + "a,0,0,1,0,0,1,0,0,1,1,2,1,1,1,1,1,1\n", term, 3, "column metallic: 2 is outside [0, 1]");
    refuses(kHeader + "a,0,0,1\n", term, 3, "line 2: has 4 cells where there are 18 columns");
}

TEST_F(Probe, SuggestsTheNearestName)
{
    refuses(kHeader, {"--term", "distribution", "--method", "bekmann"}, 2, "did you mean beckmann?");
    refuses(kHeader, {"--term", "fresnl"}, 2, "did you mean fresnel?");
    refuses(kHeader, {"--term", "brdf", "--method", "ggx"}, 2, "use --preset");
    refuses(kHeader, {"--term", "environment_specular"}, 2, "torrance compare");
}

TEST_F(Probe, ATableWithoutRowsGivesOneWithoutRows)
{
    const Outcome outcome = probe(kHeader, {"--term", "brdf"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_EQ(outcome.output, "id,device_r,device_g,device_b,cpu_r,cpu_g,cpu_b,rel,kappa\n");
}

} // namespace
} // namespace torrance::test
