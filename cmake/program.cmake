# SPDX-License-Identifier: MIT
# The program, `polhode`.
find_package(CLI11 REQUIRED)

file(GLOB_RECURSE cli_sources CONFIGURE_DEPENDS cli/*.cpp)
add_executable(polhode_cli ${cli_sources})
set_target_properties(polhode_cli PROPERTIES OUTPUT_NAME polhode)
target_compile_options(polhode_cli PRIVATE -O1)  # parsing and printing: compile time matters more
target_link_libraries(polhode_cli PRIVATE polhode polhode_flags CLI11::CLI11 fmt::fmt
                                          nlohmann_json::nlohmann_json Threads::Threads)
polhode_precompile(polhode_cli)
polhode_compile_in_groups(polhode_cli ${cli_sources})
