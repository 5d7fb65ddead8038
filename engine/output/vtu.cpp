#include "engine/output/vtu.hpp"

#include "engine/base/problems.hpp"

#include <fmt/format.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersion.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace demlua::output {

namespace {

using observe::Field;
using observe::Snapshot;

template <class T>
struct ArrayOf;
template <>
struct ArrayOf<double> {
    using Type = vtkDoubleArray;
};
template <>
struct ArrayOf<std::int32_t> {
    using Type = vtkIntArray;
};

/// One and three components are handed to VTK where they lie; the snapshot outlives the grid.
template <class T>
vtkSmartPointer<vtkDataArray> array_on(const std::vector<T>& values, int components) {
    const auto array = vtkSmartPointer<typename ArrayOf<T>::Type>::New();
    array->SetNumberOfComponents(components);
    // VTK takes a pointer to what it may change; nothing here does.
    array->SetArray(const_cast<T*>(values.data()), static_cast<vtkIdType>(values.size()), 1);
    return array;
}

/// Plane vectors with a third component, because VTK knows only vectors of space.
template <class T>
vtkSmartPointer<vtkDataArray> array_in_space(const std::vector<T>& values) {
    const auto array = vtkSmartPointer<typename ArrayOf<T>::Type>::New();
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 2));
    T* out = array->GetPointer(0);
    for (std::size_t k = 0; k + 1 < values.size(); k += 2) {
        *out++ = values[k];
        *out++ = values[k + 1];
        *out++ = T{0};
    }
    return array;
}

void name_components(vtkDataArray& array, int components) {
    if (components == 1) return;
    constexpr std::array vector_names{"x", "y", "z"};
    constexpr std::array stress_names{"xx", "yy", "xy"};
    for (std::size_t c = 0; c < 3; ++c) {
        array.SetComponentName(static_cast<vtkIdType>(c), (components == 2 ? vector_names : stress_names).at(c));
    }
}

template <class T>
vtkSmartPointer<vtkDataArray> array_of(const Field& field, const std::vector<T>& values, std::size_t rows) {
    if (field.components < 1 || field.components > 3) {
        throw RunError(
            fmt::format("field {} has {} components: VTK files take 1, 2 or 3", field.name, field.components));
    }
    if (values.size() != rows * static_cast<std::size_t>(field.components)) {
        throw RunError(fmt::format("field {} has {} numbers for {} rows", field.name, values.size(), rows));
    }
    auto array = field.components == 2 ? array_in_space(values) : array_on(values, field.components);
    array->SetName(field.name.c_str());
    name_components(*array, field.components);
    if (!field.unit.empty()) array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), field.unit.c_str());
    return array;
}

void add_fields(vtkFieldData& data, const std::vector<Field>& fields, std::size_t rows) {
    for (const Field& field : fields) {
        data.AddArray(std::visit([&](const auto& values) { return array_of(field, values, rows); }, field.values));
    }
}

void add_points(vtkUnstructuredGrid& grid, const std::vector<Vec2>& positions) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
    for (std::size_t k = 0; k < positions.size(); ++k) {
        points->SetPoint(static_cast<vtkIdType>(k), positions[k].x, positions[k].y, 0.0);
    }
    grid.SetPoints(points);
}

/// Cells of one kind, `ends` points each. 32 bits an index where they suffice: half the bytes to compress.
template <class PointOf>
void add_cells(vtkUnstructuredGrid& grid, int kind, std::size_t count, std::size_t ends, const PointOf& point_of) {
    const auto rows = static_cast<vtkIdType>(count);
    const vtkIdType points = rows * static_cast<vtkIdType>(ends);
    vtkNew<vtkIntArray> offsets;
    vtkNew<vtkIntArray> connectivity;
    offsets->SetNumberOfValues(rows + 1);
    connectivity->SetNumberOfValues(points);
    for (vtkIdType k = 0; k <= rows; ++k) offsets->SetValue(k, static_cast<int>(k) * static_cast<int>(ends));
    for (vtkIdType k = 0; k < points; ++k) {
        connectivity->SetValue(k, static_cast<int>(point_of(static_cast<std::size_t>(k))));
    }
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets, connectivity);
    grid.SetCells(kind, cells);
}

void add_time(vtkUnstructuredGrid& grid, const Snapshot& snapshot) {
    vtkNew<vtkDoubleArray> time;
    time->SetName("TimeValue");
    time->InsertNextValue(snapshot.time);
    grid.GetFieldData()->AddArray(time);
}

std::string text_of(vtkUnstructuredGrid& grid) {
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(&grid);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToLZ4();
    writer->WriteToOutputStringOn();
    if (writer->Write() == 0) throw RunError("VTK could not write the frame");
    return writer->GetOutputString();
}

} // namespace

std::string elements_vtu(const Snapshot& snapshot) {
    vtkNew<vtkUnstructuredGrid> grid;
    add_points(*grid, snapshot.position);
    add_cells(*grid, VTK_VERTEX, snapshot.position.size(), 1, [](std::size_t k) { return k; });
    add_fields(*grid->GetPointData(), snapshot.element_fields, snapshot.position.size());
    add_time(*grid, snapshot);
    return text_of(*grid);
}

std::string bonds_vtu(const Snapshot& snapshot) {
    vtkNew<vtkUnstructuredGrid> grid;
    add_points(*grid, snapshot.position);
    add_cells(*grid, VTK_LINE, snapshot.bond_ends.size(), 2,
              [&](std::size_t k) { return snapshot.bond_ends[k / 2][k % 2]; });
    add_fields(*grid->GetCellData(), snapshot.bond_fields, snapshot.bond_ends.size());
    add_time(*grid, snapshot);
    return text_of(*grid);
}

std::string cracks_vtu(const Snapshot& snapshot) {
    vtkNew<vtkUnstructuredGrid> grid;
    std::vector<Vec2> points;
    for (const auto& ends : snapshot.crack_ends) points.insert(points.end(), ends.begin(), ends.end());
    add_points(*grid, points);
    add_cells(*grid, VTK_LINE, snapshot.crack_ends.size(), 2, [](std::size_t k) { return k; });
    add_fields(*grid->GetCellData(), snapshot.crack_fields, snapshot.crack_ends.size());
    add_time(*grid, snapshot);
    return text_of(*grid);
}

std::string walls_vtu(const Snapshot& snapshot) {
    vtkNew<vtkUnstructuredGrid> grid;
    std::vector<Vec2> points;
    vtkNew<vtkCellArray> cells;
    for (const std::vector<Vec2>& path : snapshot.wall_paths) {
        cells->InsertNextCell(static_cast<int>(path.size()));
        for (const Vec2 point : path) {
            cells->InsertCellPoint(static_cast<vtkIdType>(points.size()));
            points.push_back(point);
        }
    }
    add_points(*grid, points);
    grid->SetCells(VTK_POLY_LINE, cells);
    vtkNew<vtkStringArray> names;
    names->SetName("name");
    for (const std::string& name : snapshot.wall_names) names->InsertNextValue(name);
    grid->GetCellData()->AddArray(names);
    add_fields(*grid->GetCellData(), snapshot.wall_fields, snapshot.wall_paths.size());
    add_time(*grid, snapshot);
    return text_of(*grid);
}

std::string vtk_version() { return vtkVersion::GetVTKVersion(); }

} // namespace demlua::output
