import "./main.css";
import { readData } from "../common/data.js";
import { element } from "../common/dom.js";

document.body.append(element("h1", {}, readData().title));
