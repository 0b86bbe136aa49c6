# SPDX-License-Identifier: MIT
# Writes a C++ source that contains each file as a raw string, by its path below data/.
string(REPLACE "|" ";" files "${FILES}")
set(text "#include \"io/files/embedded.hpp\"\n\nnamespace polhode {\n\n")
string(APPEND text "std::span<const EmbeddedFile> embedded_files() {\n")
string(APPEND text "  static constexpr EmbeddedFile files[] = {\n")
foreach(file IN LISTS files)
  file(RELATIVE_PATH path "${ROOT}" "${file}")
  file(READ "${file}" content)
  string(APPEND text "    {\"${path}\", R\"~data~(${content})~data~\"},\n")
endforeach()
string(APPEND text "  };\n  return files;\n}\n\n}  // namespace polhode\n")
file(WRITE "${OUTPUT}" "${text}")
