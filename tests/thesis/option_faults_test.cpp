#include "option_faults.h"

#include <string>

#include <catch2/catch.hpp>

using namespace talus::tools;

TEST_CASE("A seed is a whole number of 64 bits") {
  CHECK(fault_of_seed("0").empty());
  CHECK(fault_of_seed("18446744073709551615").empty());
  const std::string wrong = GENERATE(as<std::string>{}, "", "-1", "1.5", "18446744073709551616", "0x1", "1 ");
  CHECK_THAT(fault_of_seed(wrong), Catch::Contains("'" + wrong + "'") && Catch::Contains("from 0 to"));
}

TEST_CASE("An invalid number is outside every range") {
  CHECK(fault_of_number("0.5", 0, 1).empty());
  CHECK(fault_of_number("1", 0, 1).empty());
  const std::string wrong = GENERATE(as<std::string>{}, "", "nan", "inf", "-0.1", "1.01", "half", "0.5x");
  CHECK_THAT(fault_of_number(wrong, 0, 1), Catch::Contains("from 0 to 1"));
}
