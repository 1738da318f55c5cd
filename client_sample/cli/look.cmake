# look_table.cpp: the tables of look.json, which the viewer reads too, for look.h.
set(look_file ${CMAKE_CURRENT_SOURCE_DIR}/../look.json)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${look_file})
file(READ ${look_file} look)

# Sets `last` to the index of the last entry of a list in the file, which has `least` entries at least.
function(talus_look_last list least last)
  string(JSON count LENGTH "${look}" ${list})
  if(count LESS ${least})
    message(FATAL_ERROR "${look_file}: ${list} has ${count} entries, and must have ${least} at least")
  endif()
  math(EXPR count "${count} - 1")
  set(${last} ${count} PARENT_SCOPE)
endfunction()

set(light "")
talus_look_last(light 2 last)  # between which it is mixed
foreach(i RANGE ${last})
  string(JSON at GET "${look}" light ${i} at)
  string(JSON exposure GET "${look}" light ${i} exposure)
  set(colours "")
  foreach(name sunLight skyLight zenith horizon glow)
    string(JSON rgb GET "${look}" light ${i} ${name} 0)
    string(JSON times GET "${look}" light ${i} ${name} 1)
    string(REPLACE "#" "0x" rgb ${rgb})
    string(APPEND colours "{${rgb}, look_number(${times})}, ")
  endforeach()
  string(APPEND light "      {look_number(${at}), ${colours}look_number(${exposure})},\n")
endforeach()

set(rules "")
talus_look_last(looks 1 last)
foreach(i RANGE ${last})
  string(JSON words GET "${look}" looks ${i} 0)
  string(JSON name GET "${look}" looks ${i} 1)
  string(APPEND rules "      {R\"(${words})\", \"${name}\"},\n")
endforeach()

set(tints "")
talus_look_last(tints 1 last)
foreach(i RANGE ${last})
  string(JSON name GET "${look}" tints ${i} look)
  string(JSON grey GET "${look}" tints ${i} grey)
  foreach(channel 0 1 2)
    string(JSON times_${channel} GET "${look}" tints ${i} times ${channel})
  endforeach()
  string(APPEND tints "      {\"${name}\", look_number(${grey}), {look_number(${times_0}), look_number(${times_1}), look_number(${times_2})}},\n")
endforeach()

file(CONFIGURE OUTPUT look_table.cpp @ONLY CONTENT [=[
// Written by client_sample/cli/look.cmake of client_sample/look.json.
#include "look.h"

namespace talus::cli {
namespace {

constexpr float look_number(double value) {
  return static_cast<float>(value);
}

}  // namespace

const std::vector<LightKey>& light_keys() {
  static const std::vector<LightKey> kKeys{
@light@  };
  return kKeys;
}

const std::vector<LookRule>& look_rules() {
  static const std::vector<LookRule> kRules{
@rules@  };
  return kRules;
}

const std::vector<LookTint>& look_tints() {
  static const std::vector<LookTint> kTints{
@tints@  };
  return kTints;
}

}  // namespace talus::cli
]=])
