// SPDX-License-Identifier: MIT
#include "report/schema.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "report/report_page.hpp"
#include "results/json.hpp"

namespace talus::report {

std::string find_schema_faults(const nlohmann::json& document) {
  std::ifstream file(std::string(TALUS_SOURCE_DIR) + "/web/contract/report.schema.json");
  const nlohmann::json text = nlohmann::json::parse(file);
  valijson::Schema schema;
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema);
  valijson::Validator validator;
  valijson::ValidationResults results;
  validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results);
  std::string faults;
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& step : error.context) faults += step;
    faults += ": " + error.description + "\n";
  }
  return faults;
}

TEST(ResultsSchema, IsThatOfThePage) {
  EXPECT_EQ(read_text(TALUS_SOURCE_DIR "/web/contract/results.schema.json"), results::write_schema())
      << "write it again: talus schema --results > web/contract/results.schema.json";
}

}  // namespace talus::report
