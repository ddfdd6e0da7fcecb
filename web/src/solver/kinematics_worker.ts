import { expose } from 'comlink';
import createSolver from '#wasm/solver.js';
import { kinematicsService } from './kinematics_service.ts';

expose(kinematicsService((wasmBinary) => createSolver({ wasmBinary })));
