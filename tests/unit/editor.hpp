#pragma once

#include "config/json_schema.hpp"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace matpoint {

/// valijson, an independent reader of JSON Schema, with the schema of a catalogue.
class Editor {
  public:
    explicit Editor(Catalogue& catalogue) {
        // valijson knows the default object type of nlohmann, not the ordered one.
        schema_json_ = nlohmann::json::parse(json_schema(catalogue).dump());
        valijson::SchemaParser parser;
        parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_json_), schema_);
    }
    bool accepts(const Json& scene) const {
        const nlohmann::json target = nlohmann::json::parse(scene.dump());
        valijson::Validator validator;
        return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(target), nullptr);
    }

  private:
    nlohmann::json schema_json_;
    valijson::Schema schema_;
};

}  // namespace matpoint
