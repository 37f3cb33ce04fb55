# cmake -DFOLDER=/usr/share/javascript/vega -DCOPYRIGHT=... -DOUTPUT=vega.js -P vega.cmake: one script that defines `vega` with
# parse() and View, out of the modules of Debian's libjs-vega. Each is CommonJS; a few lines stand in for its loader. (As plain
# scripts they would not do: every module begins by emptying the global `vega`.)
set(MODULES util format loader dataflow time scale canvas scenegraph expression selection statistics functions runtime view
    event-selector parser transforms view-transforms encode label)

set(LICENCE "")
if(EXISTS "${COPYRIGHT}")
  file(READ "${COPYRIGHT}" LICENCE)
endif()
file(WRITE "${OUTPUT}" "/* Vega, https://vega.github.io/vega\n${LICENCE}*/\n"
  "var vega = (function () { var modules = {}, known = {};\n"
  "function require(name) { if (name in known) return known[name]; var m = { exports: {} };\n"
  "known[name] = m.exports; modules[name](m, m.exports, require); return known[name] = m.exports; }\n")
foreach(MODULE ${MODULES})
  file(READ "${FOLDER}/vega-${MODULE}.min.js" TEXT)
  string(FIND "${TEXT}" "//# sourceMappingURL" END REVERSE)
  string(SUBSTRING "${TEXT}" 0 ${END} TEXT)
  file(APPEND "${OUTPUT}" "modules['vega-${MODULE}'] = function (module, exports, require) {" "${TEXT}" "};\n")
endforeach()
file(APPEND "${OUTPUT}" "modules['vega-selections'] = modules['vega-selection'];\n"
  "var dataflow = require('vega-dataflow');\n"
  "require('vega-util').extend(dataflow.transforms, require('vega-transforms'), require('vega-view-transforms'),\n"
  "require('vega-encode'), require('vega-label'));\n"
  "return { parse: require('vega-parser').parse, View: require('vega-view').View }; })();\n")
