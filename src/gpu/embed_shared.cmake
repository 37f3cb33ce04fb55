# usage: cmake -D FOLDER=shaders/shared -D OUTPUT=FILE -P embed_shared.cmake
# Writes a C++ file that holds the text of the headers that C++ and GLSL share.
file(GLOB HEADERS RELATIVE ${FOLDER} ${FOLDER}/*.h)
list(SORT HEADERS)
set(TEXT "#include \"gpu/shader_folder.h\"\n\nnamespace torrance::gpu {\n\nstd::span<const SharedHeader> sharedHeaders()\n{\n    static constexpr SharedHeader kHeaders[] = {\n")
foreach(HEADER ${HEADERS})
  file(READ ${FOLDER}/${HEADER} CONTENT)
  string(APPEND TEXT "        {\"${HEADER}\", R\"shared(${CONTENT})shared\"},\n")
endforeach()
string(APPEND TEXT "    };\n    return kHeaders;\n}\n\n} // namespace torrance::gpu\n")
file(WRITE ${OUTPUT} "${TEXT}")
