// SPDX-License-Identifier: Apache-2.0
// node run_onnx.mjs NODE_MODULES FOLDER COUNT: runs ONNX Runtime on FOLDER/0.onnx with the rows of
// numbers of FOLDER/0.in, and so on, and prints, row by row, every output. Exit code 77: there is no
// such runtime.
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
  const text = readFileSync(`${folder}/${model}.in`, 'utf8').trim();
  const rows = text.split('\n').map(line => line.trim().split(/\s+/).map(Number));
  const session =
      await ort.InferenceSession.create(new Uint8Array(readFileSync(`${folder}/${model}.onnx`)));
  const seen =
      new ort.Tensor('float32', Float32Array.from(rows.flat()), [rows.length, rows[0].length]);
  const said = await session.run({[session.inputNames[0]]: seen});
  for (let i = 0; i < rows.length; ++i) {
    const numbers = session.outputNames.flatMap(name => {
      const width = said[name].dims[1];
      return Array.from(said[name].data.slice(i * width, (i + 1) * width));
    });
    console.log(numbers.join(' '));
  }
}
