// SPDX-License-Identifier: MIT

/** The text of a shader, for bundlers that load such files as text. */
declare const text: string;
export default text;
