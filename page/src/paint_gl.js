// SPDX-License-Identifier: MIT
// Draws pieces of path by WebGL: broad lines as long as they are few.
import {
  BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments, Scene, WebGLRenderer,
} from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

const BROAD_MOST = 60000; // pieces: more are drawn a pixel wide
const WIDTH = 2.2; // [px]

// Throws where there is no WebGL.
export function makeGl(holder) {
  const renderer = new WebGLRenderer({ antialias: true });
  renderer.domElement.className = "paint";
  holder.prepend(renderer.domElement);
  const scene = new Scene();
  const material = {
    broad: new LineMaterial({ vertexColors: true, linewidth: WIDTH }),
    fine: new LineBasicMaterial({ vertexColors: true }),
  };
  let drawn = null;

  function broad(pieces) {
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(pieces.positions.subarray(0, 6 * pieces.count));
    geometry.setColors(Float32Array.from(pieces.colours.subarray(0, 6 * pieces.count),
      (level) => (level / 255) ** 2.2));
    return new LineSegments2(geometry, material.broad);
  }

  function fine(pieces) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position",
      new BufferAttribute(pieces.positions.slice(0, 6 * pieces.count), 3));
    geometry.setAttribute("color", new BufferAttribute(
      Float32Array.from(pieces.colours.subarray(0, 6 * pieces.count),
        (level) => (level / 255) ** 2.2), 3));
    return new LineSegments(geometry, material.fine);
  }

  return {
    kind: "webgl",
    ground: (colour) => renderer.setClearColor(colour),
    resize(width, height) {
      renderer.setPixelRatio(window.devicePixelRatio);
      renderer.setSize(width, height);
      material.broad.resolution.set(width, height);
    },
    take(pieces) {
      if (drawn) {
        scene.remove(drawn);
        drawn.geometry.dispose();
      }
      drawn = (pieces.count <= BROAD_MOST ? broad : fine)(pieces);
      drawn.frustumCulled = false;
      scene.add(drawn);
    },
    draw(camera) {
      renderer.render(scene, camera);
    },
    // Waits till what was asked for is drawn.
    finish() {
      const gl = renderer.getContext();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      if (gl.isContextLost()) throw new Error("WebGL is lost");
    },
  };
}
