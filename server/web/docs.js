"use strict";

// An element with text or children; text never becomes markup.
function make(name, className, ...children) {
  const element = document.createElement(name);
  if (className) element.className = className;
  element.append(...children);
  return element;
}

function resolve(document_, value) {
  if (!value || !value.$ref) return value;
  return value.$ref.slice(2).split("/").reduce((node, key) => node[key], document_);
}

function typeOf(document_, schema) {
  if (!schema) return "";
  if (schema.$ref) return schema.$ref.split("/").pop();
  if (schema.enum) return schema.enum.map(String).join(" | ");
  if (schema.type === "array") return `${typeOf(document_, schema.items)}[]`;
  return Array.isArray(schema.type) ? schema.type.join(" | ") : schema.type || "any";
}

function table(heads, rows) {
  const head = make("tr", "", ...heads.map((text) => make("th", "", text)));
  const body = rows.map((cells) => make("tr", "", ...cells.map((cell) => make("td", "", cell))));
  return make("table", "", make("thead", "", head), make("tbody", "", ...body));
}

function schemaTable(document_, schema) {
  const known = resolve(document_, schema);
  if (!known || !known.properties) return null;
  return table(["member", "type", ""], Object.entries(known.properties).map(([name, member]) => [
    make("code", "", name), make("span", "mono", typeOf(document_, member)), member.description || "",
  ]));
}

function contentPart(document_, title, content) {
  const part = make("div", "");
  for (const [type, media] of Object.entries(content || {})) {
    part.append(make("p", "", `${title} `, make("code", "", type), " ",
      make("span", "mono soft", typeOf(document_, media.schema))));
    const members = schemaTable(document_, media.schema);
    if (members) part.append(members);
  }
  return part;
}

function operationBody(document_, operation) {
  const body = make("div", "");
  if (operation.description) body.append(make("p", "", operation.description));
  const parameters = (operation.parameters || []).map((one) => resolve(document_, one));
  if (parameters.length) {
    body.append(table(["parameter", "in", "type", ""], parameters.map((one) => [
      make("code", "", one.name), one.in, make("span", "mono", typeOf(document_, one.schema)),
      one.description || "",
    ])));
  }
  if (operation.requestBody) body.append(contentPart(document_, "Takes", operation.requestBody.content));
  for (const [status, response] of Object.entries(operation.responses)) {
    const known = resolve(document_, response);
    body.append(make("p", "", make("b", "", status), ` ${known.description}`));
    if (status !== "default") body.append(contentPart(document_, "Gives", known.content));
  }
  return body;
}

function operationElement(document_, method, path, operation) {
  const summary = make("summary", "", make("span", `method ${method}`, method.toUpperCase()),
    make("span", "path", path), make("span", "soft", operation.summary || ""));
  const element = make("details", "operation", summary);
  element.id = operation.operationId;
  element.dataset.words = `${method} ${path} ${operation.summary}`.toLowerCase();
  element.addEventListener("toggle", () => {
    if (element.open && element.children.length === 1) element.append(operationBody(document_, operation));
  });
  return element;
}

function show(document_) {
  document.getElementById("about").replaceChildren(
    ...document_.info.description.split("\n\n").map((text) => make("p", "", text)));
  const main = document.getElementById("operations");
  for (const tag of document_.tags) {
    const section = make("section", "", make("h2", "", tag.name), make("p", "soft", tag.description));
    section.id = tag.name.replace(/ /g, "-");
    for (const [path, methods] of Object.entries(document_.paths)) {
      for (const [method, operation] of Object.entries(methods)) {
        if (operation.tags.includes(tag.name)) {
          section.append(operationElement(document_, method, path, operation));
        }
      }
    }
    main.append(section);
    const link = make("a", "", tag.name);
    link.href = `#${section.id}`;
    document.getElementById("tags").append(link);
  }
  if (location.hash) {
    const target = document.getElementById(location.hash.slice(1));
    if (target) { target.open = true; target.scrollIntoView(); }
  }
}

function filter(words) {
  for (const element of document.querySelectorAll("details.operation")) {
    element.hidden = !element.dataset.words.includes(words);
  }
  for (const section of document.querySelectorAll("section")) {
    section.hidden = !section.querySelector("details.operation:not([hidden])");
  }
}

document.getElementById("filter").addEventListener("input", (event) => {
  filter(event.target.value.trim().toLowerCase());
});

fetch("/openapi.json").then((answer) => answer.json()).then(show).catch((error) => {
  document.getElementById("about").textContent = `The description cannot be read: ${error.message}`;
});
