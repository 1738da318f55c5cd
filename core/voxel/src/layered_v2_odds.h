// How likely each step is in each context, as train_odds (tests/bench) found it on the sample worlds at
// levels 0 to 4. Part of the payload's format: FORMAT.md lists the same numbers, and a change needs a new
// kCodecVersion.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace talus::codec {

/// Of 4096: where the shares of "one up", "one down" and "further" begin; "as predicted" begins at 0.
struct Odds {
  std::uint16_t up;
  std::uint16_t down;
  std::uint16_t further;
};

// clang-format off
inline constexpr std::array<Odds, 48> kOdds{{
    {4075, 4090, 4093}, {4044, 4090, 4093}, {4025, 4055, 4093}, {4005, 4090, 4093},
    {3954, 4053, 4093}, {3926, 4090, 4093}, {3896, 3950, 4093}, {3875, 3886, 4093},
    {3855, 4089, 4093}, {3849, 3982, 4091}, {3729, 3765, 4093}, {3669, 4090, 4093},
    {3573, 4070, 4093}, {3538, 3550, 4093}, {3486, 3769, 4084}, {3425, 3951, 4088},
    {3351, 3415, 4093}, {3263, 4086, 4089}, {3142, 3994, 4091}, {2926, 4074, 4088},
    {2895, 2902, 4093}, {2859, 3078, 4054}, {2782, 3288, 3291}, {2447, 3968, 3971},
    {2440, 4081, 4085}, {2285, 2322, 4027}, {2285, 3644, 3896}, {2062, 4062, 4086},
    {1951, 1954, 4088}, {1622, 4081, 4084}, {1571, 1587, 4058}, {1289, 4089, 4092},
    {1243, 3932, 3979}, {1230, 1233, 4086}, {969, 974, 3950}, {851, 2195, 2647},
    {842, 4016, 4025}, {806, 1085, 3210}, {581, 584, 4022}, {551, 4066, 4069},
    {324, 3873, 3876}, {295, 2625, 2646}, {156, 4061, 4064}, {144, 147, 3565},
    {134, 181, 459}, {132, 3587, 3590}, {130, 133, 4004}, {85, 88, 2710},
}};

/// By context, which of kOdds: 0 to 9, A to Z, a to l.
inline constexpr std::string_view kOddsOfContext =
    "GGGGEFLEIDGLEFJIJOLQQQRTRRVAFQ9IRRRTEFQ8JTOVdLQJQRRNTd6ENFJTJRVEIWFOTNVdBWJQWVNag"
    "cXPYSGYSESKLPD9PA4ULFP9BPA9D7EDAFKACD7F728G4BPGCL9CA4BA6FA6FE9C24J6COIJOEITQRVFOV"
    "lcUlYLhULhYLlUEYPGlULbPEcULhcUbUEcPGcXLYK9YL9hXEbKFcPEYUPYSEcLFPKLPG9PE8PLEPEJPEF"
    "8B0OB3aOB555530WJ8aB0WH0jB5HBHTHBWOH888B81fTBWJ5aH3jJBBHBNJBVRHBC8BB3fTHOJBRRCfOJ"
    "B80H81OBHB55510T80TB8RM1V30O15J55gB0O38B00g80aBBVM5d33H5BJ5BgB5TBBB51gH1aHHWNBjB5"
    "880B30R00C80530O10HB0JB1O10BB0880O00H80510R30JB0JB3T30H80553T50J80310T10OH3NNBV10"
    "QWVQQRWWWHWdWWVeeeWWfWadjjjgfdZQVdeeLWaWWajjjifgWWaffjMegQWaWfeMWWWWWfjjgjjbWefff"
    "cLBcPFWQRYLHPEBRJJYLJbIJTTTPIVYQRTROLITLRVWaaPEOLRVaadLRaLRTHWWQTaQaddddZaaWggjjj"
    "hPEhPLbbUhPEbGFPLEbLFYACLEIhLIkPIKLFcKCP65FIJkUCU98QIJbLIYLILQNPEILIHRRObQOQRRWaW"
    "jO0aHCETVWJBWJ8feHdBgdO5if3WNJaJHiaTNJHWJHieJdROaOCifHVNJWOHiaRTJHWOHifNVNHWNJifN"
    "NOERH5gH0OH5RHBjR3TJ0THCjW0gJJdJHQREdJHdOHfe1dOHeRHje8gOOdJJfRJgJJaOHfa3gJJjaHfj5"
    "OBEJ80R0EOB0OHBWH0RH0RH0VB0TCEOH0V0ERC5OHBaJ0TH0VNHdJ0NO0NJBRHERH0OHBdB0aN0fNNaR0"
    "YcYSSUUPLPSPKGLPLIPPLLEILLQPSP77GGEIPPL72ELEILbJL9IA9IPPbDALLEJDLL69QEIJHQREQRLFR"
    "hhhkkchcPkcckcUhXLkYPcSLkYPcccXUUcUGcYUXSPcSEkXPYSGcULUXYKKKUK6KKPDAGUGFPLLKAEKKL"
    "lllllllhSlhhlYblYPlhblbYlhYlllhhhlY0hhhhcYlYPlhlhYblhbhhhkcchcfkcYcXXhUEhYbcSPkYb"
    "B10OBHTH0530J53OB8d8EdC0dH3N3Jg35e8HJ58d5BaBBa80gCBeH8N50VBBWHBNBBaHCWHBTO0aJBWJB"
    "80EJHEH8EBBEH5EH50J0ET0EO50H30O30OB0JC0R50O50TOET50RB0R80a10a50TB0a35T50eB0dB0e80"
    "HEEJEEJ0EO0EH0EH0EREEREER0EREEJ0EO0ET0ER0EJ0EOEEJEER0EO0EO0EO0ER0EJ0EO00T0EH0EO0E"
    "RWWQWWWWZWeZWfZQZbfZfZZbQLLdgeejfafZWaffffQZZjflefbQQMeefjffgZbffiffZZZZifiVffZQL"
    "FFEQQQIQLQWZQZbIbbQZZZbbLYYJRNZWWOZiNWWQZbQbbNfMZbbQLPTaaWZZQZiWeWWZZQZbeZZZbQQEL"
    "LLLZZMQZiZZQZZlQZbbZZiblbbbLLEiZZTZbQQQibbZblZZDilbbccQQQZZbQbiQQQibbbbYbbQlYYbUU"
    "iiEiiiiikiiiilliiliEEiikiQiiiEiiiiiiiiliiliZiiiiiibiaiiiiiiiiiiiiMiiliiiiiiiiliWb"
    "ikEilEiiEilEbbiihbilEbhkiLEibEiliiiEilEPbliElblEPPbiEkibEbliiiEilkZbhiihZhEQLbiFk"
    "iEEEkEEEEiEEbckikEEEES0EihEikEl0EiEEhEEbbiiYEiEELbEicEiEEllEiEElkEYbbilElEELbEEUE";
static_assert(kOddsOfContext.size() == 1944);

/// Of 4096: where the share of each place of the list 2, -2, 3, -3, ... begins; the last share, up to
/// 4096, is that of all places from 15 on.
inline constexpr std::array<std::uint16_t, 17> kFurther{
    0, 1973, 3587, 3753, 3799, 3849, 3852, 3882, 3885, 3902, 3905, 3925, 3928, 3947, 3950, 3968, 4096};
// clang-format on

}  // namespace talus::codec
