#include "model/io/json_options.h"

namespace lodestone {

nlohmann::ordered_json toJson(const OptionValues& values) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for (const auto& [name, value] : values) {
    std::visit([&, &key = name](const auto& v) { object[key] = v; }, value);
  }
  return object;
}

OptionValues optionValuesFrom(const nlohmann::ordered_json& object, Diagnostics& diagnostics) {
  OptionValues values;
  if (!object.is_object()) return values;
  for (const auto& [name, value] : object.items()) {
    if (value.is_boolean()) {
      values.emplace_back(name, value.get<bool>());
    } else if (value.is_number_integer()) {
      values.emplace_back(name, value.get<std::int64_t>());
    } else if (value.is_number()) {
      values.emplace_back(name, value.get<double>());
    } else if (value.is_string()) {
      values.emplace_back(name, value.get<std::string>());
    } else {
      diagnostics.push_back(diagnose(Code::OptionBadValue, name));
    }
  }
  return values;
}

}  // namespace lodestone
