/** Script of a worker that answers requests: `new Worker(address, { type: "module" })`. */

import { serve } from "./viscoroll.js";

serve();
