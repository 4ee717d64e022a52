// Text of bytes, shorter than they are: deflated, in base64.

async function through(
  stream: CompressionStream | DecompressionStream,
  bytes: Uint8Array,
): Promise<Uint8Array<ArrayBuffer>> {
  const piped = new Blob([bytes as BlobPart]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(piped).arrayBuffer());
}

/** For an address. */
export async function packed(bytes: Uint8Array): Promise<string> {
  let characters = "";
  for (const byte of await through(new CompressionStream("deflate-raw"), bytes))
    characters += String.fromCharCode(byte);
  return btoa(characters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** Of an address, or of base64 as it is elsewhere. Fails where it is half of one. */
export async function unpacked(text: string): Promise<Uint8Array<ArrayBuffer>> {
  if (typeof DecompressionStream === "undefined") throw new Error("this browser cannot unpack what the page holds");
  const characters = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(characters, (character) => character.charCodeAt(0));
  return await through(new DecompressionStream("deflate-raw"), bytes);
}
