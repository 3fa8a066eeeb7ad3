// TOML by its parts, for colouring: a list of lines, each of them [{ kind, text }], with kind "heading", "key", "text", "number",
// "word", "comment" or none. What is not TOML stays plain.

const quotes = ['"""', "'''", '"', "'"];
const isSpace = (letter) => letter === " " || letter === "\t" || letter === "\r";
const endsWord = (letter) => isSpace(letter) || "\n,]}#=\"'[{".includes(letter);

class Lexer {
  constructor(text) {
    this.text = text;
    this.at = 0;
    this.lines = [[]];
    this.depth = []; // of "[" and "{" within a value
  }

  read() {
    while (this.at < this.text.length) {
      if (this.isAtStatement()) this.readStatement();
      else this.readValuePart();
    }
    return this.lines;
  }

  // Where a line of its own begins, within no value.
  isAtStatement() {
    return this.depth.length === 0 && this.lines.at(-1).every(({ kind, text }) => !kind && text.trim() === "") && !isSpace(this.text[this.at]) && this.text[this.at] !== "\n";
  }

  readStatement() {
    const letter = this.text[this.at];
    if (letter === "#") this.readComment();
    else if (letter === "[") this.readHeading();
    else this.readKey();
  }

  readHeading() {
    let end = this.at;
    while (end < this.text.length && this.text[end] !== "\n" && this.text[end] !== "#") end = this.afterOne(end);
    this.add("heading", this.text.slice(this.at, end).trimEnd().length);
  }

  // Up to "=", quoted parts of it whole.
  readKey() {
    let end = this.at;
    while (end < this.text.length && !"=\n#,}".includes(this.text[end])) end = this.afterOne(end);
    const length = this.text.slice(this.at, end).trimEnd().length;
    this.add(this.text[end] === "=" ? "key" : "", Math.max(length, 1));
  }

  readComment() {
    const end = this.text.indexOf("\n", this.at);
    this.add("comment", (end < 0 ? this.text.length : end) - this.at);
  }

  readValuePart() {
    const letter = this.text[this.at];
    if (letter === "\n") this.endLine();
    else if (letter === "#") this.readComment();
    else if (quotes.includes(letter)) this.add("text", this.afterOne(this.at) - this.at);
    else if (isSpace(letter) || letter === "," || letter === "=") this.add("", 1);
    else if (letter === "[" || letter === "{") this.open(letter);
    else if (letter === "]" || letter === "}") this.close();
    else this.readWord();
  }

  open(letter) {
    this.depth.push(letter);
    this.add("", 1);
  }

  close() {
    this.depth.pop();
    this.add("", 1);
  }

  // A number, a word, or the key of an inline table.
  readWord() {
    let end = this.at;
    while (end < this.text.length && !endsWord(this.text[end])) end++;
    const word = this.text.slice(this.at, Math.max(end, this.at + 1));
    const isKey = this.depth.at(-1) === "{" && this.text.slice(end).trimStart().startsWith("=");
    this.add(isKey ? "key" : isNumber(word) ? "number" : word === "true" || word === "false" ? "word" : "", word.length);
  }

  // Past the letter at a place, or past the text that begins there.
  afterOne(at) {
    const quote = quotes.find((candidate) => this.text.startsWith(candidate, at));
    if (!quote) return at + 1;
    for (let i = at + quote.length; i < this.text.length; i++) {
      if (this.text[i] === "\\" && quote[0] === '"') i++;
      else if (this.text.startsWith(quote, i)) return i + quote.length;
      else if (this.text[i] === "\n" && quote.length === 1) return i;
    }
    return this.text.length;
  }

  add(kind, length) {
    const pieces = this.text.slice(this.at, this.at + length).split("\n");
    this.at += length;
    pieces.forEach((text, i) => {
      if (i > 0) this.lines.push([]);
      if (text) this.lines.at(-1).push({ kind, text });
    });
  }

  endLine() {
    this.lines.push([]);
    this.at++;
  }
}

function isNumber(word) {
  return /^[+-]?(\d[\d_.]*(e[+-]?\d+)?|0[xob][\da-f_]+|inf|nan)$/i.test(word);
}

export const readToml = (text) => new Lexer(text).read();
