#include <matpoint/component.hpp>
#include <matpoint/profile.hpp>

#include <cxxabi.h>

#include <boost/core/demangle.hpp>
#include <new>
#include <typeinfo>

namespace matpoint {

std::string to_string(const Origin& origin) {
    return origin.kind + " \"" + origin.type + "\" of plugin \"" + origin.plugin + "\" " + origin.version;
}

Component::~Component() = default;

ComponentFailure::ComponentFailure(Origin origin, const std::string& reason, bool out_of_memory)
    : std::runtime_error((origin.pointer.empty() ? "" : origin.pointer + ": ") + reason),
      origin_(std::move(origin)),
      reason_(reason),
      out_of_memory_(out_of_memory) {}

ComponentFailure::~ComponentFailure() = default;

std::string text_of_exception() {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return "not enough memory";
    } catch (const std::exception& exception) {
        const std::string type = boost::core::demangle(typeid(exception).name());
        if (type == exception.what()) return type;
        const bool told = dynamic_cast<const std::runtime_error*>(&exception);  // meant to be read
        return told ? exception.what() : type + ": " + exception.what();
    } catch (...) {
        const std::type_info* const type = abi::__cxa_current_exception_type();
        return "something of type " + (type ? boost::core::demangle(type->name()) : "unknown") +
               ", which is no std::exception";
    }
}

void throw_failure(const Origin& origin, const char* function) {
    bool out_of_memory = false;
    try {
        throw;
    } catch (const ComponentFailure&) {
        throw;
    } catch (const FormulaError&) {
        throw;  // the user's
    } catch (const std::bad_alloc&) {
        out_of_memory = true;
    } catch (...) {
    }
    throw ComponentFailure(
        origin, to_string(origin) + " failed in its " + function + ": " + text_of_exception(), out_of_memory);
}

}  // namespace matpoint
