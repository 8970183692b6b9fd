// three.js from its sources, without what this page never draws: virtual reality, environments, shadows, physical materials.
// Shaders lose their comments and indentation.

import { readFile } from "node:fs/promises";
import { resolve } from "node:path";

/** Shaders of other materials, and parts that are empty without shadows, textures, fog, bones and the like. */
const UNUSED = new RegExp(
  "/(ShaderLib/(background|backgroundCube|cube|depth|distance|equirect|meshmatcap|meshnormal|meshphong|meshphysical|meshtoon|points|shadow|sprite|vsm)" +
    "|ShaderChunk/(lights_physical_\\w+|lights_toon_\\w+|lights_phong_\\w+|transmission_\\w+|iridescence_\\w+|clearcoat_\\w+|envmap_physical_pars_fragment" +
    "|cube_uv_reflection_fragment|(aomap|lightmap|bumpmap|normalmap|displacementmap|emissivemap|envmap|gradientmap|roughnessmap|metalnessmap|skinning|skinbase|skinnormal" +
    "|morph\\w+|fog|alphamap|uv|dithering|batching|clipping_planes)(_\\w+)?|normal_fragment_maps|specularmap_pars_fragment|shadowmap_pars_fragment|shadowmap_vertex|shadowmap_pars_vertex|lightprobes_\\w+|tonemapping_pars_fragment|alphahash_pars_fragment))\\.glsl\\.js$",
);

/** Modules in place of others. */
const STUBS = {
  "WebXRManager.js": `
    import { EventDispatcher } from "../../core/EventDispatcher.js";
    export class WebXRManager extends EventDispatcher {
      enabled = false; isPresenting = false; cameraAutoUpdate = false;
      setAnimationLoop() {} dispose() {} getCamera() { return null; } updateCamera() {}
      hasDepthSensing() { return false; } getDepthSensingMesh() { return null; } getEnvironmentBlendMode() { return "opaque"; }
    }`,
  "PMREMGenerator.js": "export class PMREMGenerator { dispose() {} fromCubemap() { return null; } fromEquirectangular() { return null; } }",
  "WebGLShadowMap.js": "export class WebGLShadowMap { enabled = false; autoUpdate = false; needsUpdate = false; type = 1; render() {} }",
  "DFGLUTData.js": "export function getDFGLUT() { return null; }\nexport const DATA = null;",
};

export const slimThree = {
  name: "three",
  setup(build) {
    build.onResolve({ filter: /^three$/ }, () => ({ path: resolve("node_modules/three/src/Three.js") }));
    build.onLoad({ filter: /three[\\/]src[\\/].*(\.glsl|WebXRManager|WebGLShadowMap|PMREMGenerator|DFGLUTData)\.js$/ }, async ({ path }) => {
      const slashed = path.replaceAll("\\", "/");
      const stub = STUBS[slashed.split("/").pop()];
      if (stub) return { contents: stub, loader: "js" };
      const text = await readFile(path, "utf8");
      if (UNUSED.test(slashed)) {
        return { contents: text.includes("export const vertex") ? 'export const vertex = "";\nexport const fragment = "";' : 'export default "";' };
      }
      return { contents: text.replaceAll(/^\s*\/\/.*$/gm, "").replaceAll(/\/\*(?!\s*glsl)[^]*?\*\//g, "").replaceAll(/[ \t]+\/\/.*$/gm, "").replaceAll(/^\s+/gm, ""), loader: "js" };
    });
  },
};
