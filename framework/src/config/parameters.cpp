#include <matpoint/geometry.hpp>
#include <matpoint/parameters.hpp>

namespace matpoint {

std::array<double, 3> Parameters::vector(const char* name) const {
    const Json& given = own_->at(name);
    std::array<double, 3> v{};
    for (std::size_t i = 0; i < given.size() && i < v.size(); ++i) v[i] = given[i].get<double>();
    return v;
}

std::filesystem::path Parameters::file(const char* name) const {
    return context_->folder / text(name);
}

std::shared_ptr<Geometry> Parameters::geometry(const char* name) const {
    return context_->registry->make<Geometry>("geometry", own_->at(name), *context_, pointer_ + "/" + name);
}

std::vector<std::shared_ptr<Geometry>> Parameters::geometries(const char* name) const {
    std::vector<std::shared_ptr<Geometry>> made;
    for (const Json& own : own_->at(name)) {
        const std::string pointer = pointer_ + "/" + name + "/" + std::to_string(made.size());
        made.push_back(context_->registry->make<Geometry>("geometry", own, *context_, pointer));
    }
    return made;
}

std::vector<Parameters> Parameters::objects(const char* name) const {
    std::vector<Parameters> all;
    for (const Json& own : own_->at(name))
        all.emplace_back(own, *context_, pointer_ + "/" + name + "/" + std::to_string(all.size()));
    return all;
}

}  // namespace matpoint
