#include <matpoint/field_shape.hpp>
#include <matpoint/particles.hpp>

namespace matpoint {

FieldShape field_shape(const std::string& field, int components, SpaceId space) {
    if (field == "displacement") return FieldShape::vector;
    if (field == "deformation_gradient") return FieldShape::matrix;
    if (const auto known = field_from_name(field)) {
        switch (*known) {
            case Field::position:
            case Field::velocity:
            case Field::half_size:
            case Field::initial_half_size:
            case Field::initial_position:
            case Field::position_remainder:
            case Field::initial_position_remainder:
            case Field::velocity_remainder:
                return FieldShape::vector;
            case Field::stress:
            case Field::total_stress:
                return FieldShape::symmetric;
            case Field::displacement_gradient:
            case Field::grid_velocity_gradient:
            case Field::velocity_gradient:
            case Field::affine_velocity:
                return FieldShape::matrix;
            case Field::mass:
            case Field::volume:
            case Field::volume_remainder:
            case Field::id:
                return FieldShape::scalar;
        }
    }
    if (components == 1) return FieldShape::scalar;
    return components == space.dimension() ? FieldShape::vector : FieldShape::list;
}

std::vector<std::string> component_names(FieldShape shape, int components, SpaceId space) {
    const std::string axes = "xyz";
    const int dimension = space.dimension();
    const auto axis = [&](int a) { return axes.substr(static_cast<std::size_t>(a), 1); };
    std::vector<std::string> names;
    switch (shape) {
        case FieldShape::scalar:
            names = {""};
            break;
        case FieldShape::vector:
            for (int a = 0; a < dimension; ++a) names.push_back(axis(a));
            break;
        case FieldShape::symmetric:
            names = {"xx", "yy", "zz", "xy", "yz", "xz"};
            names.resize(static_cast<std::size_t>(components));
            break;
        case FieldShape::matrix:
            for (int c = 0; c < dimension * dimension; ++c)
                names.push_back(axis(c % dimension) + axis(c / dimension));
            if (components > dimension * dimension) names.push_back("zz");
            break;
        case FieldShape::list:
            for (int c = 0; c < components; ++c) names.push_back(std::to_string(c));
            break;
    }
    return names;
}

std::vector<std::string> column_names(const std::string& field, int components, SpaceId space) {
    std::vector<std::string> names =
        component_names(field_shape(field, components, space), components, space);
    for (std::string& name : names) name = name.empty() ? field : field + "_" + name;
    return names;
}

}  // namespace matpoint
