#include "app/probe_rows.h"

#include "core/error.h"
#include "files/csv_read.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace torrance {
namespace {

constexpr double kGreatest = 1e6; // of colours and indices: their squares stay far from the end of float

class Rows
{
public:
    Rows(std::string_view csv, const std::string& f) : file(f), table(parseCsv(csv, f)) {}

    std::size_t count() const { return table.rows.size(); }
    const std::string& text(std::size_t row, std::string_view name) const
    {
        return table.rows[row][table.column(name, file)];
    }

    double number(std::size_t row, const std::string& name, double greatest) const
    {
        const double value = csvNumber(table, row, table.column(name, file), file);
        if (value < 0 || value > greatest)
            throw inputError(file, place(row, name), fmt::format("{} is outside [0, {}]", value, greatest),
                             "write a value within it");
        return value;
    }

    dvec3 vector(std::size_t row, const std::string& name)
    {
        dvec3 v;
        for (int i = 0; i < 3; ++i)
            v[i] = csvNumber(table, row, table.column(name + "xyz"[i], file), file);
        if (v == dvec3(0))
            throw inputError(file, place(row, name + "x " + name + "y " + name + "z"), "is a vector of zero length",
                             "give a direction");
        if (nonUnit.empty() && !(std::abs(std::hypot(v.x, v.y, v.z) - 1.0) <= kUnitTolerance))
            nonUnit = place(row, name + "x " + name + "y " + name + "z");
        return v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); // whose square no double overflows
    }

    dvec3 color(std::size_t row, const std::string& name) const
    {
        return {number(row, name + "_r", kGreatest), number(row, name + "_g", kGreatest),
                number(row, name + "_b", kGreatest)};
    }

    dvec3 tangent(std::size_t row, const dvec3& n)
    {
        const dvec3 t = vector(row, "t");
        if (glm::cross(n, glm::normalize(t)) == dvec3(0))
            throw inputError(file, place(row, "tx ty tz"), "lies along the normal", "give a direction in the surface");
        return t;
    }

    const std::string& firstNonUnit() const { return nonUnit; }

    void require(std::string_view name) const { table.column(name, file); }

private:
    std::string place(std::size_t row, const std::string& name) const
    {
        return fmt::format("line {}, column {}", table.lines[row], name);
    }

    const std::string& file;
    CsvTable table;
    std::string nonUnit; // where the first of them stands
};

brdf::ShadingPoint pointOf(Rows& rows, std::size_t row, const ProbeColumns& columns)
{
    const dvec3 n = rows.vector(row, "n"), v = rows.vector(row, "v"), l = rows.vector(row, "l");
    brdf::ShadingPoint point = brdf::makeShadingPoint(n, v, l, rows.number(row, "roughness", 1));
    if (columns.baseColor)
        point.baseColor = rows.color(row, "base");
    if (columns.metallic)
        point.metallic = rows.number(row, "metallic", 1);
    if (columns.ior)
        point.ior = rows.number(row, "ior", kGreatest);
    if (columns.conductor) {
        point.eta = dvec3(rows.number(row, "eta", kGreatest));
        point.k = dvec3(rows.number(row, "k", kGreatest));
    }
    if (columns.f82)
        point.f82 = rows.color(row, "f82");
    if (columns.tangent)
        brdf::setAnisotropy(point, rows.tangent(row, point.n), rows.number(row, "anisotropy", 1));
    return point;
}

// Of a table without rows too.
void requireColumns(const Rows& rows, const ProbeColumns& columns)
{
    for (const char* name : {"id", "nx", "ny", "nz", "vx", "vy", "vz", "lx", "ly", "lz", "roughness"})
        rows.require(name);
    if (columns.baseColor)
        for (const char* name : {"base_r", "base_g", "base_b"})
            rows.require(name);
    if (columns.metallic)
        rows.require("metallic");
    if (columns.ior)
        rows.require("ior");
    if (columns.conductor)
        for (const char* name : {"eta", "k"})
            rows.require(name);
    if (columns.f82)
        for (const char* name : {"f82_r", "f82_g", "f82_b"})
            rows.require(name);
    if (columns.tangent)
        for (const char* name : {"tx", "ty", "tz", "anisotropy"})
            rows.require(name);
}

} // namespace

ProbeRows parseProbeRows(std::string_view csv, const std::string& file, const ProbeColumns& columns)
{
    Rows rows(csv, file);
    requireColumns(rows, columns);
    ProbeRows result;
    for (std::size_t row = 0; row < rows.count(); ++row) {
        result.ids.push_back(rows.text(row, "id"));
        result.points.push_back(pointOf(rows, row, columns));
    }
    result.nonUnit = rows.firstNonUnit();
    return result;
}

} // namespace torrance
