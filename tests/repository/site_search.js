// The search of the built site: what a newcomer types is found first or second. node site_search.js FOLDER
const fs = require("fs"), vm = require("vm");
const folder = process.argv[2], site = {};
vm.createContext(site);
for (const file of ["search_index.js", "site_search.js"])
  vm.runInContext(fs.readFileSync(`${folder}/${file}`, "utf8").replace(/^(const|let) /m, "var "), site);

const expected = {
  "own mechanism": "guide_your_mechanism.html",
  "how do I add a mechanism": "guide_your_mechanism.html",
  "capacity": "glossary.html",
  "which law": "guide_which_law.html",
  "MuJoCo": "guide_mujoco.html",
  "simulation": "guide_mujoco.html",
  "equation 12": "equations.html",
  "CHAI3D": "guide_chai3d.html",
  "URDF": "guide_urdf.html",
  "robot": "guide_urdf.html",
  "controller": "classpassive__haptics_1_1controller.html",
  "python simulated_device": "guide_python_reference.html",
  "read_log": "guide_python_reference.html",
  "mechanism.design_map": "guide_python_reference.html",
};
let missed = 0;
for (const [typed, page] of Object.entries(expected)) {
  const first = site.found_sections(site.site_sections, typed).slice(0, 2).map(hit => hit.url);
  if (first.some(url => url.split("#")[0] === page)) continue;
  console.error(`'${typed}' finds ${first.join(", ") || "nothing"} first; expected ${page} among the first two`);
  ++missed;
}
for (const typed of ["", "zzqqzz", "how do I"]) {
  if (site.found_sections(site.site_sections, typed).length === 0) continue;
  console.error(`'${typed}' should find nothing`);
  ++missed;
}
process.exit(missed ? 1 : 0);
