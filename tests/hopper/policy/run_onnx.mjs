// SPDX-License-Identifier: Apache-2.0
// node run_onnx.mjs NODE_MODULES FOLDER COUNT: runs ONNX Runtime on FOLDER/0.onnx with the rows of
// numbers of FOLDER/0.in, and so on, and prints, row by row, every output. A model that goes by the
// time is shown the rows of FOLDER/0.course too. Exit code 77: there is no such runtime.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {pathToFileURL} from 'node:url';

const [modules, folder, count] = process.argv.slice(2);
let ort;
try {
  const place = createRequire(`${modules}/x.js`).resolve('onnxruntime-web');
  ort = await import(pathToFileURL(place));
} catch {
  process.exit(77);
}
ort.env.wasm.numThreads = 1;
for (let model = 0; model < Number(count); ++model) {
  const table = ending => {
    const lines = readFileSync(`${folder}/${model}.${ending}`, 'utf8').trim().split('\n');
    const rows = lines.map(line => line.trim().split(/\s+/).map(Number));
    return new ort.Tensor('float32', Float32Array.from(rows.flat()), [rows.length, rows[0].length]);
  };
  const session =
      await ort.InferenceSession.create(new Uint8Array(readFileSync(`${folder}/${model}.onnx`)));
  const shown = {observation: table('in')};
  if (session.inputNames.includes('course')) shown.course = table('course');
  const said = await session.run(shown);
  for (let i = 0; i < shown.observation.dims[0]; ++i) {
    const numbers = session.outputNames.flatMap(name => {
      const width = said[name].dims[1];
      return Array.from(said[name].data.slice(i * width, (i + 1) * width));
    });
    console.log(numbers.join(' '));
  }
}
