#pragma once

#include <matpoint/profile.hpp>
#include <matpoint/schema.hpp>
#include <matpoint/space.hpp>

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace matpoint {

class Registry;
class Geometry;

/// What a component is made from: its own object in the resolved scene (every default filled in,
/// SI units, checked against its Schema) and the few facts of the scene around it.
class Parameters {
  public:
    struct Context {
        SpaceId space;
        std::filesystem::path folder;        ///< the scene's folder; file parameters are relative to it
        const Registry* registry = nullptr;  ///< makes nested components
        const Json* scene = nullptr;         ///< the whole resolved scene
        std::function<void(const std::string&)> warn{};  ///< takes what warn() says
    };

    /// `pointer`: JSON pointer to `own` in the scene.
    Parameters(const Json& own, const Context& context, std::string pointer = {})
        : own_(&own), context_(&context), pointer_(std::move(pointer)) {}

    bool has(const char* name) const { return own_->contains(name) && !own_->at(name).is_null(); }
    double number(const char* name) const { return own_->at(name).get<double>(); }
    long integer(const char* name) const { return own_->at(name).get<long>(); }
    bool boolean(const char* name) const { return own_->at(name).get<bool>(); }
    std::string text(const char* name) const { return own_->at(name).get<std::string>(); }
    std::vector<std::string> texts(const char* name) const {
        return own_->at(name).get<std::vector<std::string>>();
    }
    std::vector<double> numbers(const char* name) const { return own_->at(name).get<std::vector<double>>(); }
    /// A vector or per_axis parameter; axes that the space lacks are zero.
    std::array<double, 3> vector(const char* name) const;
    Profile profile(const char* name) const { return Profile(own_->at(name)); }
    std::filesystem::path file(const char* name) const;
    /// A nested component of kind geometry.
    std::shared_ptr<Geometry> geometry(const char* name) const;
    std::vector<std::shared_ptr<Geometry>> geometries(const char* name) const;
    /// Those of a list of objects.
    std::vector<Parameters> objects(const char* name) const;

    /// Tells the user of something that works, but that they may not have meant.
    void warn(const std::string& text) const {
        if (context_->warn) context_->warn(text);
    }

    const Json& json() const { return *own_; }
    const Context& context() const { return *context_; }
    const std::string& pointer() const { return pointer_; }

  private:
    const Json* own_;
    const Context* context_;
    std::string pointer_;
};

}  // namespace matpoint
