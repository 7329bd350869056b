/*! cotouch page; sources 671e87ff0c1bf5b8cabec6555b9d4b7b471c143006db8d7c2ce3a35274de6fe3; licences of what it contains: licences.txt */
var Ku=["#0072B2","#D55E00","#009E73","#CC79A7","#E69F00","#56B4E9","#8B6F47","#6B7280"],e_=["#3D9FE0","#F08438","#2BC495","#DE97BF","#F2B73C","#86CCF5","#B3946A","#9CA3AF"];var hm=["#D8BE98","#9DB4CE","#B3C99C","#D0A9C3","#E3AF90","#98CBC4","#DDD394","#BBB5AE"];function um(i,e){return e??hm[i%hm.length]}var t_=["#414487","#355F8D","#2A788E","#21908D","#22A884","#43BF71","#7AD151","#BBDF27","#FDE725"],Rl=t_,Cl=typeof matchMedia=="function"?matchMedia("(prefers-color-scheme: dark)"):null;function Ks(i){return i==="dark"||i==="auto"&&Cl!==null&&Cl.matches}function eo(i){return Cl?.addEventListener("change",i),()=>Cl?.removeEventListener("change",i)}function wi(i,e){return(e?e_:Ku)[i%Ku.length]}function dm(i,e=document.documentElement){let t=Ks(i);e.dataset.theme=t?"dark":"light",e.style.colorScheme=t?"dark":"light";for(let n=0;n<Ku.length;n++)e.style.setProperty(`--user-${n}`,wi(n,t))}function es(i){let e=parseInt(i.slice(1),16);return[e>>16,e>>8&255,e&255]}function Zs(i,e){return`rgb(${es(i).join(" ")} / ${e})`}var fm=["script","free","hold","pull","wander","grab","ball","blade","cut","pose"];var n_=["ball","grab","free","blade","pose"],ju=3,Zu=32,pm=80;function mm(i,e){let t=new Uint8Array(ts(i));return Uint8Array.from({length:e},(n,s)=>t[s>>3]>>7-(s&7)&1)}function ts(i){let e=atob(i),t=new Uint8Array(e.length);for(let n=0;n<e.length;n++)t[n]=e.charCodeAt(n);return t.buffer}var i_=1e-4,s_=1e4,r_=256;function o_(i,e){if(!i)return null;let t=new Uint16Array(ts(String(i.heights))),{rows:n,columns:s,size:r,top:o,angle:a,projection:l}=i,c=[n,s].every(d=>Number.isInteger(d)&&d>=1&&d<=r_)&&t.length===n*s,h=Array.isArray(r)&&r.length===2&&r.every(d=>d>=i_*e&&d<=s_*e),u=Number.isFinite(a)&&o>0&&o<=e&&["x","y","z","triplanar"].includes(l);return c&&h&&u?{heights:t,rows:n,columns:s,size:[r[0],r[1]],top:o,angle:a,projection:l}:null}function gm(i){let e=new Float32Array(ts(i.nodes.rest)),t=i.skin&&{vertices:i.skin.vertices,rest:new Float32Array(ts(i.skin.rest)),triangles:new Uint32Array(ts(i.skin.triangles)),node:new Uint32Array(ts(i.skin.node))},n=i.cutting&&{elements:i.cutting.elements,pointer:new Uint32Array(ts(i.cutting.pointer)),element:new Uint32Array(ts(i.cutting.element)),beyond:new Int32Array(ts(i.cutting.beyond))};return{...i,nodes:{count:i.nodes.count,rest:e},skin:t,cutting:n??null,parts:i.parts??[],texture:o_(i.texture,i.radius),edges:i.edges?new Uint32Array(ts(i.edges)):null,started:String(i.started),points:t?t.rest:e}}function Pl(i,e){return[i.getFloat32(e,!0),i.getFloat32(e+4,!0),i.getFloat32(e+8,!0)]}function ym(i,e){let t=new DataView(i);if(i.byteLength<Zu||t.getUint8(0)!==1||t.getUint8(1)!==ju)throw new RangeError(`not a frame of version ${ju}`);let n=t.getUint16(2,!0),s=t.getUint32(16,!0),r=pm+4*Math.ceil(s*6/4);if(i.byteLength!==Zu+n*r)throw new RangeError("a frame of the wrong length");let o=[];for(let a=0;a<n;a++){let l=Zu+a*r,c=t.getUint8(l+2);o.push({slot:t.getUint8(l),mode:fm[t.getUint8(l+1)]??"free",direct:(c&1)>0,hasHand:(c&2)>0,hands:t.getUint8(l+3),age:t.getFloat32(l+4,!0),target:Pl(t,l+8),place:Pl(t,l+20),force:Pl(t,l+32),radius:t.getFloat32(l+44,!0),energy:t.getFloat32(l+48,!0),supplied:t.getFloat32(l+52,!0),lost:t.getFloat32(l+56,!0),linked:t.getFloat32(l+60,!0),node:t.getInt32(l+64,!0),edge:Pl(t,l+68),displacement:new Int16Array(i,l+pm,s*3)})}return{number:t.getUint32(4,!0),time:t.getFloat64(8,!0),points:s,scale:t.getFloat32(20,!0),echo:t.getUint32(24,!0),served:t.getUint32(28,!0)/1e6,copies:o,received:e}}function vm(i){let e=new DataView(new ArrayBuffer(52));return e.setUint8(0,2),e.setUint8(1,i.slot),e.setUint8(2,n_.indexOf(i.action)),e.setUint32(4,i.number,!0),e.setUint32(8,i.point,!0),i.target.forEach((t,n)=>e.setFloat32(12+4*n,t,!0)),e.setFloat32(24,i.radius,!0),e.setFloat32(28,i.stiffness,!0),e.setFloat64(32,i.time,!0),i.edge.forEach((t,n)=>e.setFloat32(40+4*n,t,!0)),e.buffer}function xm(i,e,t){let n=new DataView(new ArrayBuffer(16));return n.setUint8(0,3),n.setUint32(4,i,!0),n.setFloat32(8,e,!0),n.setFloat32(12,t,!0),n.buffer}function _m(i,e,t){return JSON.stringify({type:"hello",version:ju,token:i,slot:e,want:"all",rate:t})}var Il=class{gaps=[];last=0;every=0;lead=4;get ahead(){return this.lead}picture(e){let t=e-this.last;t<=0||(this.last=e,!(t>60)&&(this.gaps.push(t),this.gaps.length>24&&this.gaps.shift(),this.gaps.length===24&&(this.every=[...this.gaps].sort((n,s)=>n-s)[6])))}came(e){if(!this.every||e-this.last>240)return[0,0];let t=this.until(e);return t<.5||t>this.lead+Math.min(3.5,.35*this.every)?this.lead+=.6:this.lead-=.04,this.lead>this.every+.5&&(this.lead-=this.every),this.lead<.5&&(this.lead=.5),[this.until(e+this.lead),this.every]}until(e){let t=(e-this.last)%this.every;return t<0?-t:this.every-t}};var Qu=250,bm=2e3,a_=1e4,ed=500,l_=3e3,c_=8e3,h_=5e3,u_=8,d_=60,f_=300,p_=5,Mm=[0,0,0];function m_(i,e){return i.action===e.action&&i.point===e.point&&i.radius===e.radius&&i.stiffness===e.stiffness&&i.target.every((t,n)=>t===e.target[n])&&(i.edge??Mm).every((t,n)=>t===(e.edge??Mm)[n])}var Ll=class{constructor(e,t,n){this.store=e;this.token=t;this.address=n;e.on("slot",()=>this.hello()),document.addEventListener("visibilitychange",()=>{this.heard=performance.now(),this.hello()}),addEventListener("online",()=>this.hurry()),this.looking=window.setInterval(()=>this.look(),ed),this.dial()}store;token;address;onPoint=null;screen=new Il;socket=null;wait=Qu;timer=0;asked=0;answers=new Map;number=0;pending=null;state=null;told=null;pointed=-1/0;pointTimer=0;closed=!1;greeted=!1;said=null;heard=0;looked=performance.now();looking;get mayAct(){let{live:e,state:t,scene:n,slot:s}=this.store;return e&&this.hasToken&&t?.control!=="other"&&!!n?.own.includes(s)}get hasToken(){return this.token!==null&&this.store.scene?.acts!==!1}get tokenWrong(){return this.token!==null&&!this.hasToken}link(e,t={}){return`${e}?${new URLSearchParams({token:this.token??"",...t})}`}do(e){let t=this.socket;if(!t||t.readyState!==WebSocket.OPEN)return Promise.resolve({ok:!1,text:"There is no connection to the server."});let n=++this.asked;return new Promise(s=>{let r=setTimeout(()=>this.answer(n,{ok:!1,text:"The server did not respond."}),a_);this.answers.set(n,o=>{clearTimeout(r),s(o)}),t.send(JSON.stringify({...e,type:"do",id:n}))})}point(e){if(this.told&&m_(this.told,e))return;this.pending?.action==="free"&&e.action!=="free"&&this.flush(),this.told=e,this.pending={...e,time:e.time??performance.now()};let t=this.pointed+u_-performance.now();t<=0||e.action==="free"?this.flush():this.pointTimer||(this.pointTimer=setTimeout(()=>this.flush(),t))}close(){this.closed=!0,clearInterval(this.looking),clearTimeout(this.timer),clearTimeout(this.pointTimer),this.socket?.close()}flush(){clearTimeout(this.pointTimer),this.pointTimer=0;let e=this.pending;if(this.pending=null,!e||!this.mayAct||this.socket?.readyState!==WebSocket.OPEN)return;this.pointed=performance.now();let t=++this.number,n=e.time;this.socket.send(vm({edge:[0,0,0],...e,slot:this.store.slot,number:t,time:n})),this.onPoint?.(t,n)}dial(){if(clearTimeout(this.timer),this.closed)return;let e=new WebSocket(this.address);e.binaryType="arraybuffer",this.socket=e,this.heard=performance.now();let t="";e.onopen=()=>{this.told=null,this.hello()},e.onmessage=({data:n})=>{if(this.socket!==e)return;if(this.heard=performance.now(),this.store.connection==="silent"&&this.greeted&&this.store.connected("open"),n instanceof ArrayBuffer){let r=ym(n,performance.now());if(e.send(xm(r.number,...this.screen.came(r.received))),requestAnimationFrame(o=>this.screen.picture(o)),this.store.state?.ended&&this.store.frame)return;this.store.scene&&r.points*3===this.store.scene.points.length&&this.store.drawn(r);return}let s=JSON.parse(n);s.type==="scene"?(this.wait=Qu,this.greeted=!0,this.store.connected("open"),this.state=null,this.store.show(gm(s)),this.said!==this.store.slot&&this.hello()):s.type==="state"?this.tell(s):s.type==="answer"?this.answer(s.id,s):s.type==="error"&&(t=String(s.text))},e.onclose=()=>{this.socket===e&&this.ended(t)}}ended(e,t=!1){this.socket=null,this.greeted=!1;for(let n of[...this.answers.keys()])this.answer(n,{ok:!1,text:"The connection was lost before the server responded."});e?this.store.connected("refused",e):t?this.store.connected("silent"):this.store.connection!=="refused"&&this.store.connected(this.store.scene?"lost":"connecting"),!this.closed&&(this.timer=window.setTimeout(()=>this.dial(),e?bm:this.wait),this.wait=Math.min(2*this.wait,bm))}look(){let e=performance.now(),t=e-this.looked>3*ed;this.looked=e,t&&(this.heard=Math.max(this.heard,e-ed));let{socket:n}=this;if(!n||document.hidden)return;let s=e-this.heard;s>(this.greeted?c_:h_)?(this.socket=null,n.close(),this.ended("",!0)):this.greeted&&s>l_&&this.store.connected("silent")}tell(e){let t=this.state!==null;if(this.state=e,t)return;let n=()=>{clearTimeout(s);let r=this.state;this.state=null,r&&this.store.told(r)},s=setTimeout(n,f_);this.store.state?requestAnimationFrame(()=>setTimeout(n)):n()}hello(){this.socket?.readyState===WebSocket.OPEN&&(this.said=this.store.scene||this.store.wished!==null?this.store.slot:null,this.socket.send(_m(this.token,this.said,document.hidden?p_:d_)))}hurry(){this.socket||(this.wait=Qu,this.dial())}answer(e,t){this.answers.get(e)?.(t),this.answers.delete(e)}};var vr=class{constructor(e){this.current=e}current;listeners=new Set;get(){return this.current}set(e){if(!Object.is(e,this.current)){this.current=e;for(let t of[...this.listeners])t(e)}}on(e){return this.listeners.add(e),()=>this.listeners.delete(e)}},Sm=["users","network","plots","energy","margin","events"];function Lt(i,e){return i.scene?.users.find(t=>t.slot===e)?.name??`user ${e+1}`}function ns(i,e){return i<e?[i,e]:[e,i]}function Zn(i){return`${i[0]}-${i[1]}`}function is(i,e){return i===e||i!==null&&e!==null&&i[0]===e[0]&&i[1]===e[1]}function Nt(i,e){let{store:t,connection:n}=i;return t.live&&n.hasToken&&!!t.scene?.may.includes(e)}function wm(i,e,t){let{scene:n,frame:s}=i.store;if(!n)return null;let r=s?.copies.find(c=>c.slot===e),o=n.nodes.rest,a=r&&r.node>=0&&r.node<n.nodes.count?r.node:-1;if(a<0){let c=-1/0;for(let h=0;h<n.nodes.count;h++){let u=o[3*h]*t[0]+o[3*h+1]*t[1]+o[3*h+2]*t[2];u>c+1e-9&&([c,a]=[u,h])}}if(a<0)return null;let l=n.dimension===1?Math.max(n.radius,.1):.35*n.radius;return{node:a,to:[0,1,2].map(c=>o[3*a+c]+l*t[c])}}var g_="http://www.w3.org/2000/svg";function Em(i,e,t){for(let[n,s]of Object.entries(e??{}))s==null||s===!1||(n.startsWith("on")&&typeof s=="function"?i.addEventListener(n.slice(2),s):i.setAttribute(n,s===!0?"":String(s)));for(let n of t)n&&i.append(n)}function k(i,e=null,...t){let n=document.createElement(i);return Em(n,e,t),n}function nn(i,e=null,...t){let n=document.createElementNS(g_,i);return Em(n,e,t),n}function Oe(i,e){i.textContent!==e&&(i.textContent=e)}function je(i,e,t){t===null?i.removeAttribute(e):i.getAttribute(e)!==t&&i.setAttribute(e,t)}function Mt(i,e){i.hidden===e&&(i.hidden=!e)}var Tm={good:"M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8M5.2 8.2l2 2 3.7-4.2",warn:"M8 2 1.8 13.2h12.4zM8 6.4v3.2M8 11.3v.3",bad:"M5.4 1.8h5.2l3.6 3.6v5.2l-3.6 3.6H5.4l-3.6-3.6V5.4zM5.8 5.8l4.4 4.4M10.2 5.8l-4.4 4.4",wait:"M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8M8 4.6V8l2.4 1.6",close:"m4 4 8 8M12 4l-8 8",cut:"M5.6 10.6 12.6 3M10.4 10.6 3.4 3M4.2 10.4a1.7 1.7 0 1 0 0 3.4 1.7 1.7 0 0 0 0-3.4M11.8 10.4a1.7 1.7 0 1 0 0 3.4 1.7 1.7 0 0 0 0-3.4",mend:"M6.6 9.4a2.6 2.6 0 0 0 3.8.2l2-2a2.6 2.6 0 0 0-3.7-3.7l-1 1M9.4 6.6a2.6 2.6 0 0 0-3.8-.2l-2 2a2.6 2.6 0 0 0 3.7 3.7l1-1",invite:"M6.4 2.4a2.6 2.6 0 1 0 0 5.2 2.6 2.6 0 0 0 0-5.2M1.8 13.6c.3-2.6 2-4 4.6-4s4.3 1.4 4.6 4M12.4 5v4M10.4 7h4",tour:"M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8m2.8 3.4L9.2 9.2l-4 1.6 1.6-4z",light:"M8 5.2a2.8 2.8 0 1 0 0 5.6 2.8 2.8 0 0 0 0-5.6M8 1.4v1.4M8 13.2v1.4M1.4 8h1.4M13.2 8h1.4M3.3 3.3l1 1M11.7 11.7l1 1M12.7 3.3l-1 1M4.3 11.7l-1 1",dark:"M13.4 9.6A5.8 5.8 0 0 1 6.4 2.6a5.8 5.8 0 1 0 7 7z",auto:"M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8v12.4M8 5h3.6M8 8h5.6M8 11h3.6",record:"M8 4.6a3.4 3.4 0 1 0 0 6.8 3.4 3.4 0 0 0 0-6.8",stop:"M4.8 4.8h6.4v6.4H4.8z",save:"M8 2.4v7M5 6.8l3 3 3-3M2.8 13.2h10.4",pause:"M5.6 3.6v8.8M10.4 3.6v8.8",play:"m5.2 3.4 7 4.6-7 4.6z",keys:"M1.8 4.4h12.4v7.4H1.8zM4.4 7h.2M7 7h.2M9.6 7h.2M12 7h.2M5 9.4h6",reset:"M3 8a5 5 0 1 0 1.6-3.7M3 2.6v2.6h2.6",grab:"M5 8.4V4.6a1 1 0 0 1 2 0V7.4 3.4a1 1 0 0 1 2 0v4-3a1 1 0 0 1 2 0v3.4-1.6a1 1 0 0 1 2 0v3.4c0 3-1.6 4.6-4.2 4.6-2 0-2.8-.8-4-2.6L2.6 8.8c.6-.8 1.6-.8 2.4-.4",ball:"M6.2 6.2a3.6 3.6 0 1 0 0-.1M1.6 13.4c3.4 0 3.4-3.4 6.2-3.4s3 3.4 6.6 3.4",blade:"M2.4 13.6 12 4l1.6-1.6c.6 2.6-.4 5-2.4 7L8.6 7.4M5.4 10.6l2 2",ghosts:"M8 2.2c-2.6 0-4.2 2-4.2 4.4v6.6l1.6-1.2 1.4 1.2L8 12l1.2 1.2 1.4-1.2 1.6 1.2V6.6c0-2.4-1.6-4.4-4.2-4.4M6.4 6.4v.4M9.6 6.4v.4",side:"M2 3.4h5v9.2H2zM9 3.4h5v9.2H9z",overlay:"M2.4 2.4h7.8v7.8H2.4zM5.8 5.8h7.8v7.8H5.8z",minus:"M3.4 8h9.2",tick:"m3.4 8.4 3 3 6.2-6.8"};function wn(i,e=16){return nn("svg",{viewBox:"0 0 16 16",width:e,height:e,class:`icon icon-${i}`,"aria-hidden":"true"},nn("path",{d:Tm[i]}))}function Vn(i,e){je(i,"class",`icon icon-${e}`);let t=i.firstElementChild;t&&je(t,"d",Tm[e])}function tt(i,e,t={}){return k("button",{type:"button",class:t.class??"button",id:t.id,"aria-label":t.label,"data-tip":t.tip,onclick:e},t.icon&&wn(t.icon),i&&k("span",null,i))}function xr(i,e,t){let n=new Map,s=k("div",{class:"choice",role:"radiogroup","aria-label":i});for(let o of e){let a=tt(o.words,()=>t(o.value),{class:"choice-one",...o.icon?{icon:o.icon}:{},...o.tip?{tip:o.tip}:{}});a.setAttribute("role","radio"),a.setAttribute("aria-checked","false"),a.dataset.value=o.value,n.set(o.value,a),s.append(a)}s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowDown:1,ArrowLeft:-1,ArrowUp:-1}[o.key];if(!a)return;let l=[...n.values()].filter(h=>!h.disabled),c=l.indexOf(document.activeElement);l[(c+a+l.length)%l.length]?.focus(),o.preventDefault(),o.stopPropagation()});let r=()=>{let o=[...n.values()],a=o.find(l=>l.getAttribute("aria-checked")==="true")??o[0];for(let l of o)je(l,"tabindex",l===a?"0":"-1")};return r(),{element:s,mark(o){for(let[a,l]of n)je(l,"aria-checked",String(a===o));r()},allow(o,a){let l=n.get(o);l&&(l.disabled=!a)},say(o,a,l){let c=n.get(o);c&&(c.lastElementChild&&Oe(c.lastElementChild,a),je(c,"data-tip",l))}}}var y_=0;function Ei(i,e,t,...n){let s=`explained-${++y_}`,r=k("div",{class:"explanation",id:s,hidden:!0},t),o=k("button",{type:"button",class:"ask","aria-expanded":"false","aria-controls":s,"aria-label":`What ${e} shows`},"?");o.addEventListener("click",()=>{r.hidden=!r.hidden,o.setAttribute("aria-expanded",String(!r.hidden))});let a=k("div",{class:"panel-head"},k("h2",{id:`${i}-title`},e),o,k("div",{class:"grow"}),...n),l=k("div",{class:"panel-body"});return{element:k("section",{id:i,class:"panel","aria-labelledby":`${i}-title`},a,r,l),body:l,head:a}}function ss(i,e){let t=Math.abs(i).toFixed(e);return i<0&&Number(t)!==0?"−"+t:t}function On(i,e=0){return i==null||!Number.isFinite(i)?"–":ss(i,e)}var v_=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"],[1e-12,"p"]];function rs(i,e,t=0){if(i==null||!Number.isFinite(i))return"–";let n=Math.abs(i);if(n<=t||n<1e-15)return`0 ${e}`;let[s,r]=v_.find(([l])=>n>=l*.9995)??[1e-12,"p"],o=i/s,a=Math.abs(o)>=99.95?0:Math.abs(o)>=9.995?1:2;return`${ss(o,a)} ${r}${e}`}function Nl(i){return i==null||!Number.isFinite(i)?"–":Math.abs(i)<10?`${ss(i,2)} N`:`${ss(i,1)} N`}function Gn(i){if(i==null||!Number.isFinite(i))return"–";let e=Math.abs(i);return e>=.9995?`${ss(i,2)} s`:`${ss(i*1e3,e<.00995?1:0)} ms`}function xn(i,e){if(i==null||!Number.isFinite(i))return"–";let t=i*100,n=Math.abs(t);return`${ss(t,e??(n===0||n>=9.95?0:1))} %`}function Am(i){return i==null||!Number.isFinite(i)?"–":Math.abs(i)<.1?`${ss(i*1e3,1)} mm`:`${ss(i*100,1)} cm`}function Dl(i){return i==null?"–":`${ss(i,0)} Hz`}function Fl(i){let e=Math.max(0,Math.floor(i));return`${Math.floor(e/60)}:${String(e%60).padStart(2,"0")}`}function ya(i){return String(Math.round(i)).replace(/\B(?=(\d{3})+$)/g," ")}function os(i,e){return`${Math.min(i,e)+1}–${Math.max(i,e)+1}`}var x_=8e3;function as(i,e,t,...n){let s=k("span",null),r=k("div",{class:`banner banner-${i}`,id:e,role:i==="bad"?"alert":"status",hidden:!0},wn(i==="info"?"wait":i,16),s,...n);return{element:r,update:()=>{let o=t();Mt(r,o!==null),o!==null&&Oe(s,o)}}}function Cm(i){let{store:e,connection:t}=i,n=tt("Restore now",()=>{i.act({what:"damping",fraction:1})},{class:"button small primary"}),s=tt("Take over",()=>{i.act({what:"control"})},{class:"button small primary"}),r=tt("Cancel",()=>i.aiming.set(null),{class:"button small"}),o=!1,a=0,l=tt("Dismiss",()=>{clearTimeout(a),a=0,y()},{class:"button small"}),c=()=>{let p=(e.state?.damping??1)<1;o&&!p&&e.live&&(a=window.setTimeout(()=>l.click(),x_)),p&&(a=0),o=p},h=()=>!!e.state?.ended,u="",d=tt("Dismiss",()=>{u=f(),y()},{class:"button small"}),f=()=>{let{state:p}=e;return[...Object.entries(p?.members??{}).filter(([,v])=>v.recording==="failed").map(([v,M])=>`The recording of ${Lt(e,Number(v))} stopped${M.recording_failure?`: ${M.recording_failure}`:""}.`),...p?.recording.troubles.length?[`${p.recording.state==="failed"?"Nothing was recorded":"The recording is incomplete"}: ${p.recording.troubles.join("; ")}.`]:[]].join(" ")},m=[as("bad","banner-lost",()=>e.connection==="lost"&&!h()?"The connection is lost; you see the last known state. Reconnecting …":null),as("bad","banner-silent",()=>h()?null:e.connection==="silent"?"The server does not respond. You see the last known state; nothing can be changed until it responds.":e.stalled?"The session’s process does not respond. Users, links and energies show their last known state; nothing can be changed until it responds.":null),as("bad","banner-refused",()=>e.connection==="refused"?`The server refused this page: ${e.refusal||"it gave no reason."}`:null),as("info","banner-ended",()=>e.connection!=="refused"&&h()?"The session has ended. You see its final state.":null),as("bad","banner-recording",()=>{let p=f();return p&&p!==u?p:null},d),as("bad","banner-damping",()=>{let p=e.state?.damping??1;return n.disabled=!Nt(i,"damping"),e.live&&p<1?`Damping is lowered to ${xn(p,p<.01?1:0)} of what is needed: energy can grow by itself.`:null},n),as("info","banner-restored",()=>a&&e.live?"Full damping is restored: the copies are coming to rest.":null,l),as("info","banner-view",()=>e.connection==="open"&&e.scene&&!t.hasToken?t.tokenWrong?"You are only watching: the token in this address does not belong to the running session. Open the latest address that cotouch printed.":"You are only watching. To take part, open the address with the token that cotouch printed.":null),as("warn","banner-control",()=>e.live&&t.hasToken&&e.state?.control==="other"?`Another page controls ${Lt(e,e.slot)}.`:null,s),as("info","banner-aim",()=>{let p=i.aiming.get();return p?`Click in the picture where ${Lt(e,p.slot)} should pull.`:null},r)],y=()=>{c();for(let g of m)g.update();let p=["silent","lost","refused"].includes(e.connection)||e.stalled;document.documentElement.toggleAttribute("data-lost",p&&!h()),document.documentElement.toggleAttribute("data-ended",h())};for(let p of["scene","state","connection","slot"])e.on(p,y);return i.aiming.on(y),y(),k("div",{class:"banners"},...m.map(p=>p.element))}var __={auto:"light",light:"dark",dark:"auto"},Rm={auto:"system",light:"light",dark:"dark"};function td(i){i.set({theme:__[i.settings.theme]})}function Pm(i){let e=tt("",()=>td(i),{icon:"auto",class:"button bare",label:"Theme",id:"theme"}),t=()=>{let{theme:n}=i.settings,s=e.querySelector("svg");s&&Vn(s,n),e.setAttribute("aria-label",`Theme: ${Rm[n]}`),e.setAttribute("data-tip",`Theme: ${Rm[n]} (D)`)};return i.on("settings",t),t(),e}var b_={good:"good",warn:"attention",bad:"not guaranteed"},M_={connecting:"Connecting …",open:"Waiting for the copies …",silent:"No response",lost:"Connection lost",refused:"Refused"};function S_(){return nn("svg",{viewBox:"0 0 24 24",width:24,height:24,class:"mark","aria-hidden":"true"},nn("circle",{cx:8,cy:9,r:5.4,class:"mark-a"}),nn("circle",{cx:16,cy:9,r:5.4,class:"mark-b"}),nn("circle",{cx:12,cy:15.6,r:5.4,class:"mark-c"}))}var w_=1e4;function E_(i){let{store:e,connection:t}=i,n=()=>e.state?.recording.state==="ending",s=()=>{Nt(i,"record")&&!n()&&i.act({what:"record",on:e.state?.recording.state!=="on"})},r=k("span",{class:"tabular"},"Record"),o=k("button",{type:"button",class:"button",id:"record","data-tip":"Record every copy, to audit or replay later (R)"},wn("record"),r);o.addEventListener("click",s);let a=tt("",()=>{T_(i)},{icon:"save",class:"button",id:"download",label:"Download the recording"});a.append(k("span",{class:"label"},"Download"));let l=-1,c=()=>{let h=e.state?.recording,u=h?.state==="on",d=!!h?.troubles.length&&h.state!=="off";je(o,"data-on",u?"":null),je(o,"data-wrong",d?"":null),je(o,"aria-pressed",String(u));let f=u?"Stop recording":n()?"Finishing the recording":"Record";je(o,"aria-label",d?`${f}; the recording is incomplete`:f);let m=o.querySelector("svg");m&&Vn(m,u?d?"warn":"stop":n()?"wait":h?.state==="failed"?"warn":"record"),Oe(r,u?Fl(h.seconds):n()?"Finishing …":"Record"),o.disabled=!Nt(i,"record")||n(),Mt(o,!!e.scene?.may.includes("record")),Mt(a,h?.state==="done"&&t.hasToken),a.disabled=e.connection!=="open",h?.state==="done"&&je(a,"data-tip",`${h.text}, as a ZIP of MCAP files`);let y=h?.state==="done"||h?.state==="failed"?h.number:0;h&&y>l&&l>=0&&i.say(h.state==="done"?`Recorded: ${h.text}.`:"Nothing was recorded.",h.troubles.length?"bad":"good"),h&&(l=y||Math.max(0,h.number-1))};for(let h of["scene","state","connection"])e.on(h,c);return c(),{element:k("div",{class:"recorder"},o,a),toggle:s}}async function T_(i){let e=i.connection.link("recording.zip");try{if(!(await fetch(e,{method:"HEAD",cache:"no-store",signal:AbortSignal.timeout(w_)})).ok)return i.say("The server no longer has the recording.","bad")}catch{return i.say("The server did not respond; the recording is still there. Try again.","bad")}k("a",{href:e,download:"cotouch-recording.zip"}).click()}function Im(i,e){let{store:t}=i,n=k("span",{class:"session"}),s=wn("wait",18),r=k("span",{class:"unseen"}),o=k("span",{class:"verdict-words"},"Connecting …"),a=k("button",{type:"button",class:"verdict",id:"verdict"},s,r,o);a.addEventListener("click",()=>i.tab.set("margin"));let l=tt("Invite",e.invite,{icon:"invite",class:"button",id:"invite",tip:"Invite somebody to take part from another computer (I)"}),c=E_(i),h=k("header",{class:"bar"},k("h1",{class:"brand"},S_(),k("span",null,"cotouch"),n),a,k("div",{class:"bar-tools"},c.element,l,tt("Tour",e.tour,{icon:"tour",class:"button",id:"tour-open",tip:"A two-minute tour of everything (T)"}),tt("",e.keys,{icon:"keys",class:"button bare",label:"Keyboard shortcuts",tip:"Keyboard shortcuts (?)"}),Pm(t))),u=()=>{Oe(n,t.scene?.title??""),je(n,"title",t.scene?`${t.scene.title} · cotouch ${t.scene.version}`:null);let d=t.live||t.state?.ended?t.state?.verdict:void 0;je(a,"data-level",d?.level??"none"),Vn(s,d?.level??"wait"),Oe(r,d?`${b_[d.level]}: `:"");let f=d?.text??M_[t.stalled?"silent":t.connection],m=f&&f[0]?.toUpperCase()+f.slice(1);Oe(o,m),je(a,"data-tip",`${m}. Safe (passive) means that nobody can take out energy that nobody put in. Click to see the margin of every link.`);let y=[t.scene?.title,"cotouch"].filter(Boolean).join(" · ");document.title!==y&&(document.title=y),l.hidden=!t.scene?.invitation};for(let d of["scene","state","connection"])t.on(d,u);return u(),{element:h,record:c.toggle}}var A_="Every step accounts for its energy, to rounding, so both bars are equally long: what came in is either still there or was damped. Hands put energy in and take some back. Links are springs between copies: they return what they store, and delay makes them return more than they took, because late samples push at the wrong moment. The damping is chosen to take at least that much; this keeps the session stable. As members join and leave, each copy’s share of the object changes, and with it its energy. The residual is rounding.";function C_(i,e,t){let n=o=>(e[o]??0)-(t?.[o]??0),s=t?t.energy??0:e.initial??0,r={slot:i,initial:s,hands:n("supplied"),links:n("linked"),shared:n("rescaled"),damped:n("lost"),stored:e.energy??0};return{...r,residual:r.initial+r.hands+r.links+r.shared-r.damped-r.stored}}function R_(i){let e=[],t=[],n=(s,r,o)=>{s>0?e.push({...r,value:s}):s<0&&t.push({...o,value:-s})};for(let s of i)n(s.hands,{label:"hand",class:"hand",slot:s.slot},{label:"taken back by hand",class:"hand",slot:s.slot});return n(i.reduce((s,r)=>s+r.initial,0),{label:"at the start",class:"initial"},{label:"at the start",class:"initial"}),n(i.reduce((s,r)=>s+r.links,0),{label:"added by links",class:"links"},{label:"stored or taken by links",class:"links"}),n(i.reduce((s,r)=>s+r.shared,0),{label:"members leaving",class:"shared"},{label:"members joining",class:"shared"}),n(-i.reduce((s,r)=>s+r.damped,0),{label:"dampers",class:"damped"},{label:"damped",class:"damped"}),n(-i.reduce((s,r)=>s+r.stored,0),{label:"copies",class:"stored"},{label:"in the copies",class:"stored"}),{came:e,went:t}}var to=[{key:"hands",words:"hands",sign:"",tip:"Put in by this user’s hand, less what it took back"},{key:"links",words:"links",sign:"+",tip:"Work of the links on this copy: what delays added, less what springs store"},{key:"initial",words:"start",sign:"+",tip:"In the copy when counting began"},{key:"shared",words:"shares",sign:"+",tip:"Gained or lost as members joined and left, which changes each copy’s share of the object"},{key:"damped",words:"damped",sign:"−",tip:"Lost in this copy’s dampers"},{key:"stored",words:"in copy",sign:"−",tip:"In this copy now, in motion and in springs"},{key:"residual",words:"rest",sign:"=",tip:"The residual: rounding"}],nd=[[1e3,"kJ"],[1,"J"],[.001,"mJ"],[1e-6,"µJ"],[1e-9,"nJ"]];function Lm(i,e){let t=Math.abs(i)/e;return Math.abs(i)<1e-12?"0":On(i/e,t>=99.95?0:t>=9.995?1:2)}var P_=7;function Nm(i,e,t,n){for(;i.children.length>e.length;)i.lastElementChild?.remove();for(;i.children.length<e.length;)i.append(k("div",null,k("span")));e.forEach((s,r)=>{let o=i.children[r],a=t>0?s.value/t:0,l=s.slot===void 0?s.label:`${s.label} of ${n(s.slot)}`;je(o,"class",`part part-${s.class}`),o.style.width=`${(100*a).toFixed(2)}%`,s.slot!==void 0&&(o.style.setProperty("--user",`var(--user-${s.slot})`),o.style.setProperty("--on-user",`var(--on-user-${s.slot})`)),je(o,"data-tip",`${l}: ${rs(s.value,"J",1e-12)}`);let c=s.slot===void 0?s.label:String(s.slot+1);o.firstElementChild&&Oe(o.firstElementChild,a*i.clientWidth>8+P_*c.length?c:"")})}function Fm(i){let{store:e}=i,t=new Map,n=tt("Count from now",()=>{if(t.size)t.clear();else for(let[E,T]of Object.entries(e.state?.members??{}))t.set(Number(E),{...T});M()},{class:"button small",tip:"Ignore everything before now"}),{element:s,body:r}=Ei("energy","Energy",A_,n),[o,a]=[k("div",{class:"stack"}),k("div",{class:"stack"})],[l,c]=[k("span",{class:"sum tabular"}),k("span",{class:"sum tabular"})],h=k("th",{scope:"col"}),u=k("tr",null,h,...to.map(E=>k("th",{scope:"col","data-tip":E.tip,tabindex:0},`${E.sign} ${E.words}`.trim()))),d=k("tbody"),f=to.map(()=>k("td")),m=k("p",{class:"expected tabular"}),y=k("p",{class:"hint"},"No energy has been counted yet."),p=k("table",{class:"numbers ledger"},k("thead",null,u),d,k("tfoot",null,k("tr",null,k("th",{scope:"row"},"all"),...f))),g=k("div",{hidden:!0},k("div",{class:"bar-row"},k("span",{class:"bar-name"},"came in"),o,l),k("div",{class:"bar-row"},k("span",{class:"bar-name"},"went to"),a,c),m,k("div",{class:"scroll"},p));r.append(y,g);let v=new Map,M=()=>{if(r.offsetParent===null&&v.size)return;let E=Object.entries(e.state?.members??{}).filter(([,J])=>J.steps).map(([J,ae])=>{let re=Number(J),Q=t.get(re)??null;return Q&&(ae.steps??0)<(Q.steps??0)&&t.delete(re),C_(re,ae,t.get(re)??null)});Mt(g,E.length>0),Mt(y,E.length===0),Oe(n.firstElementChild??n,t.size?"Count from the start":"Count from now");let T=R_(E),x=J=>J.reduce((ae,re)=>ae+re.value,0),[S,O]=[x(T.came),x(T.went)],L=Math.max(S,O),R=J=>Lt(e,J);Nm(o,T.came,L,R),Nm(a,T.went,L,R),Oe(l,rs(S,"J",1e-12)),Oe(c,rs(O,"J",1e-12));let U=S-O,z=Object.values(e.state?.members??{}),I=Math.max(0,...z.map(J=>J.residual??0)),G=Math.max(0,...z.map(J=>J.closure_factor??0)),q=G>0?` Balancing the steps changed velocities by at most ${xn(G)}.`:"",H=L_(z,R);je(m,"data-left",L>0?String(Math.abs(U)/L):null),Oe(m,L>0?`Residual: ${Dm(U/L)} of what came in. Worst single step: off by ${Dm(I)} of the energy in play.${q}${H}`:"");let he=Math.max(1e-9,...E.flatMap(J=>to.map(ae=>Math.abs(J[ae.key])))),[Y,ee]=nd.find(([J])=>he>=J)??nd[nd.length-1];Oe(h,ee);for(let[J,ae]of v)E.some(re=>re.slot===J)||(ae.element.remove(),v.delete(J));for(let J of E){let ae=v.get(J.slot);if(!ae){let re=to.map(()=>k("td")),Q=k("tr",null,k("th",{scope:"row",title:R(J.slot)},k("span",{class:"badge tiny",style:`--user:var(--user-${J.slot});--on-user:var(--on-user-${J.slot})`},String(J.slot+1))),...re);ae={element:Q,cells:re},v.set(J.slot,ae),d.append(Q);for(let pe of[...v.keys()].sort((ye,Ae)=>ye-Ae))d.append(v.get(pe)?.element??Q)}to.forEach((re,Q)=>{let pe=ae.cells[Q];pe&&Oe(pe,Lm(J[re.key],Y))})}je(p,"data-initial",E.some(J=>J.initial)?"":null),to.forEach((J,ae)=>{let re=f[ae];re&&Oe(re,Lm(E.reduce((Q,pe)=>Q+pe[J.key],0),Y))})};e.on("state",M);let _=e.scene?.started;return e.on("scene",()=>{e.scene?.started!==_&&t.clear(),_=e.scene?.started,M()}),i.tab.on(M),M(),s}var I_={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};function Dm(i){if(!Number.isFinite(i))return"–";let e=Math.abs(i);if(e===0)return"0";if(e>=.01)return xn(e);let t=Math.floor(Math.log10(e));return`${Math.round(e/10**t)} · 10${[...String(t)].map(n=>I_[n]??"").join("")}`}function L_(i,e){let t=i.reduce((o,a)=>(a.cuts??0)>(o.cuts??0)?a:o,i[0]??{});if(!t.cuts)return"";let n=i.reduce((o,a)=>o+(a.cut_energy??0),0),s=(t.cut_by??[]).flatMap((o,a)=>a>0&&o>0?[`${e(a-1)} ${o}`]:[]),r=new Set(i.flatMap(o=>o.cut_set?[o.cut_set]:[])).size<2;return` Cut: ${t.cuts} elements${s.length?` (${s.join(", ")})`:""}, which stored ${rs(n,"J",1e-12)}${r?"":"; not all copies know about them yet"}.`}var N_=200;function Um(i){let{store:e}=i,{element:t,body:n}=Ei("events","Events","What happened in the session: who joined and left, which links were guarded, and what was requested. Newest first."),s=k("ol",{class:"events tabular"}),r=k("p",{class:"hint"},"Nothing has happened yet.");n.append(r,s);let o=-1/0,a=new Set,l="",c=()=>{let h=e.scene?.started??"";h!==l&&(l=h,[o,a]=[-1/0,new Set],s.replaceChildren());for(let u of e.state?.events??[]){let d=`${u.time} ${u.text}`;u.time<o||a.has(d)||(u.time>o&&a.clear(),o=u.time,a.add(d),s.prepend(k("li",null,k("time",null,Fl(u.time)),k("span",null,u.text))))}for(;s.children.length>N_;)s.lastElementChild?.remove();Mt(r,!s.children.length)};return e.on("state",c),c(),t}var D_=0;function _r(i,e,t){let n=`dialog-${++D_}`,s=k("dialog",{class:"dialog","aria-labelledby":n}),r=()=>s.close();return s.append(k("div",{class:"panel-head"},k("h2",{id:n},i),k("div",{class:"grow"}),tt("",r,{icon:"close",class:"button bare",label:"Close"})),k("div",{class:"dialog-body"},...e),k("div",{class:"dialog-actions"},...t.map(o=>{let a=tt(o.words,()=>{r(),o.act()},{class:o.class});return o.focus&&(a.autofocus=!0),a}))),s.addEventListener("click",o=>{o.target===s&&r()}),document.body.append(s),{element:s,close:r,open:()=>{s.open||s.showModal()}}}function Om(i){let e=k("p",null),t=()=>{},n=_r(i,[e],[{words:i,class:"button danger",act:()=>t()},{words:"Cancel",class:"button primary",act:()=>{},focus:!0}]),s=n.element.querySelector("h2");return{ask(r,o,a){s&&Oe(s,r),Oe(e,o),t=a,n.open()}}}var id={here:{words:"here",icon:"good"},starting:{words:"starting",icon:"wait"},gone:{words:"gone",icon:"bad"},stopped:{words:"stopped",icon:"bad"},awaited:{words:"not here yet",icon:"wait"},over:{words:"finished",icon:"tick"}};function js(i,e){let t=i?.members[e];return t?i?.ended&&t.here&&t.steps?"over":t.alive===!1?"stopped":t.here?t.steps?"here":"starting":t.alive?"starting":t.steps?"gone":"awaited":"awaited"}var hi={coupled:{words:"coupled",means:"Both ends feel each other through the spring.",icon:"good"},catching:{words:"catching up",means:"This end has caught up and is proving reliable; the link couples when both ends have.",icon:"wait"},guarded:{words:"guarded",means:"Samples are, or were, older than the budget allows. This end moves its spring only as far as its saved energy pays for.",icon:"warn"},waiting:{words:"waiting",means:"No samples arrive.",icon:"wait"},cut:{words:"cut",means:"Nothing gets through. Each end lets go of its spring without a jolt.",icon:"bad"},off:{words:"not linked",means:"These two are not linked directly.",icon:"minus"}},F_={coupled:"coupled",ready:"catching",guarded:"guarded",waiting:"waiting",keys:"waiting"};function Ul(i){return i?F_[i.state]??"waiting":"waiting"}var U_=["cut","guarded","waiting","catching","coupled"];function ws(i,e,t){if(!i)return"waiting";if(no(i,e,t))return"cut";if(!i.links.some(([s,r])=>s===e&&r===t||s===t&&r===e))return"off";let n=[Ul(i.ends[`${e}-${t}`]),Ul(i.ends[`${t}-${e}`])];return U_.find(s=>n.includes(s))??"waiting"}function km(i,e,t){let n=ws(i,e,t);return n!=="cut"&&n!=="off"&&[e,t].some(r=>i?.members[r]?.unsent)?"A copy is farther away than samples can tell, so it sends none.":hi[n].means}function no(i,e,t){return!!(i.emulated[`${e}-${t}`]?.cut||i.emulated[`${t}-${e}`]?.cut)}function Fi(i,e,t,n){let s=[i?.ends[`${e}-${t}`]?.[n],i?.ends[`${t}-${e}`]?.[n]].filter(r=>typeof r=="number");return s.length?Math.max(...s):null}function Ol(i,e,t){let[n,s]=[Fi(i,e,t,"age_sum"),Fi(i,e,t,"budget")];return n===null||s===null||s<=0?null:1-n/s}var Bm={script:"follows the script",free:"hand free",hold:"holds still",pull:"pulls",wander:"wanders",grab:"pointer grabs",ball:"pointer pushes",blade:"pointer cuts",cut:"cuts",pose:"moves a tool",elsewhere:"on another computer"};async function zm(i,e,t){try{await navigator.clipboard.writeText(e),i.say(`${t} copied.`,"good")}catch{i.say("The browser does not allow this page to copy; select the text and copy it yourself.","warn")}}function O_(i){return/^[\w.-]+$/.test(i)?i:`'${i.replaceAll("'","'\\''")}'`}function Vm(i){let{store:e,connection:t}=i,n=k("textarea",{readonly:!0,rows:3,"aria-label":"Invitation",spellcheck:"false"}),s=k("textarea",{readonly:!0,rows:1,"aria-label":"Command",spellcheck:"false"}),r=k("select",{"aria-label":"User"}),o=k("p",{class:"hint",role:"status"}),a=k("img",{alt:"The address of this page as a QR code",width:168,height:168,class:"qr"}),l=k("figcaption",null),c=k("figure",{class:"qr-frame"},a,l),h=k("p",{class:"hint"},"Only this computer can open this page. To open it on a phone with a QR code, start cotouch with --page-listen and this computer’s address."),u=tt("Free this slot",()=>{let y=Number(r.value);i.act({what:"expel",slot:y})},{class:"button small danger",icon:"stop"}),d=k("p",{class:"hint"},"Anyone with the invitation can take part, so give it only to people you trust. The other computer must be able to reach this one over the network."),f=_r("Invite",[k("div",{class:"invite"},k("div",{class:"invite-words"},k("label",{class:"field"},k("span",null,"1. Choose the user to play"),k("span",{class:"row"},r,u)),o,k("div",{class:"field"},k("span",null,"2. On the other computer, run"),s,k("span",{class:"row"},tt("Copy the command",()=>{zm(i,s.value,"Command")},{class:"button small"}))),k("div",{class:"field"},k("span",null,"3. Paste the invitation there"),n,k("span",{class:"row"},tt("Copy the invitation",()=>{zm(i,n.value,"Invitation")},{class:"button small primary"})))),c),d,h],[]),m=()=>{if(!f.element.open)return;let y=e.scene?.invitation??"",p=Number(r.value);n.value!==y&&(n.value=y);let g=`cotouch join - --name ${O_(Lt(e,p))}`;s.value!==g&&(s.value=g);let v=js(e.state,p),M=v==="here"||v==="starting",_=e.state?.members[p]?.alive===null;if(Mt(c,!!e.scene?.page),Mt(h,!e.scene?.page),e.scene?.page){let E=t.link("qr.svg",{user:String(p+1)});a.getAttribute("src")!==E&&(a.src=E),Oe(l,`opens this page on a phone, as ${Lt(e,p)}`)}Oe(o,_&&M?`${Lt(e,p)} is played on another computer. If you free the slot, whoever plays there is removed for the rest of the session.`:M?`${Lt(e,p)} is played by a process on this computer. Free the slot first; whoever then joins with this name takes it over, and the object stays.`:`The slot of ${Lt(e,p)} is free.`),Mt(u,M),u.disabled=!Nt(i,"expel")};return r.addEventListener("change",m),e.on("state",m),e.on("scene",m),{open:()=>{if(!e.scene?.invitation)return;let y=e.scene.users,p=r.value;r.replaceChildren(...y.map(v=>k("option",{value:v.slot},`${v.slot+1} · ${v.name}`)));let g=y.find(v=>!["here","starting"].includes(js(e.state,v.slot)))??y.at(-1);r.value=p||String(g?.slot??0),f.open(),m()}}}var k_="Every user moves a copy of the object in a separate process, at its own rate. A step that comes too late is skipped; the next is then longer, and energy stays exact. Force is what the hand exerts on its copy. Expand a user to tell the hand what to do, to stop the process, or to act as that user.",Gm=[{value:"script",words:"Script",tip:"Follow the session file’s script"},{value:"hold",words:"Hold",tip:"Keep what is held in its current place"},{value:"free",words:"Let go",tip:"Hold nothing"},{value:"wander",words:"Wander",tip:"Move it about slowly"},{value:"pull",words:"Pull …",tip:"Drag it to a place"}],B_=[{words:"−x",label:"back, −x",to:[-1,0,0],from:1},{words:"+x",label:"forward, +x",to:[1,0,0],from:1},{words:"−y",label:"right, −y",to:[0,-1,0],from:2},{words:"+y",label:"left, +y",to:[0,1,0],from:2},{words:"−z",label:"down, −z",to:[0,0,-1],from:3},{words:"+z",label:"up, +z",to:[0,0,1],from:3}];function sd(i,e){let t=k("dd",null,"–");return{element:k("div",{class:"metric","data-tip":e},k("dt",null,i),t),value:t}}function kl(i){let e=new URL(location.href);return e.searchParams.set("user",String(i+1)),e.href}function z_(i,e,t){let{store:n}=i,s=!!n.scene?.own.includes(e),r=()=>n.me===e,o=wn("wait",14),a=k("span",{class:"presence-words"}),l=k("span",{class:"chip chip-mine",hidden:!0},"you"),c=k("span",{class:"hand-mode"}),h=sd("rate","Steps per second"),u=sd("missed","Share of all due steps that came too late and were skipped, since the start"),d=sd("force","Force of the hand on its copy"),f=`user-${e}-more`,m=k("button",{type:"button",class:"user-head","aria-expanded":"false","aria-controls":f},k("span",{class:"badge",style:`--user:var(--user-${e});--on-user:var(--on-user-${e})`},String(e+1)),k("span",{class:"user-name",style:`--user:var(--user-${e})`},Lt(n,e)),l,k("span",{class:"grow"}),k("span",{class:"presence"},o,a));m.addEventListener("click",()=>i.opened.set(i.opened.get()===e?null:e));let y=k("div",{class:"pulls",hidden:!0}),p=(R,U={})=>{i.aiming.set(null),i.act({what:"hand",slot:e,mode:R,...U})},g=xr(`Hand of ${Lt(n,e)}`,Gm,R=>{R!=="pull"?(y.hidden=!0,p(R)):(y.hidden=!y.hidden,i.aiming.set(y.hidden?null:{slot:e}))});y.append(k("p",{class:"hint"},"Click in the picture where to pull to, or choose a direction:"),k("div",{class:"directions",role:"group","aria-label":"Direction to pull"},...B_.filter(R=>R.from<=(n.scene?.dimension??1)).map(R=>tt(R.words,()=>{let U=wm(i,e,R.to);U&&p("pull",U)},{class:"button small",label:`Pull ${R.label}`}))));let v=tt("Take over",()=>{n.take(e),history.replaceState(null,"",kl(e)),i.say(`This page now acts as ${Lt(n,e)}.`)},{class:"button small",tip:"Your pointer moves this user’s hand"}),M=tt("New window",()=>{open(kl(e),"_blank","noopener")},{class:"button small",tip:"Open another page that acts as this user"}),_=tt("Stop process",()=>{i.act({what:"kill",slot:e})},{class:"button small danger",icon:"stop",tip:"End this user’s process at once, as a crash would"}),E=tt("Remove …",()=>{let R=Lt(n,e);t.ask(`Remove ${R}?`,`${R} takes part from another computer. The slot becomes free at once, and whoever is removed cannot come back for the rest of the session.`,()=>{i.act({what:"expel",slot:e})})},{class:"button small danger",icon:"stop",tip:"Remove whoever plays this user on another computer"}),T=tt("Restart process",()=>{i.act({what:"revive",slot:e})},{class:"button small",icon:"reset"}),x=[v,M,_,E,T],S=k("div",{class:"user-more",id:f,hidden:!0},g.element,y,k("div",{class:"actions"},...x)),O=k("li",{class:"user","data-slot":e},m,k("dl",{class:"metrics"},h.element,u.element,d.element),c,S);return{element:O,update:()=>{let R=n.state?.members[e],U=js(n.state,e);Vn(o,id[U].icon),Oe(a,id[U].words),je(O,"data-presence",U),Mt(l,r()),je(O,"data-mine",r()?"":null);let z=U==="here"||U==="over"?R:void 0;Oe(h.value,Dl(z?.rate));let I=z?.missed??0,G=(z?.steps??0)+I;Oe(u.value,G?xn(I/G):"–"),je(u.element,"data-tip",G?`${ya(I)} of ${ya(G)} due steps came too late and were skipped`:null),Oe(d.value,Nl(z?.force)),Oe(c,z?Bm[z.hand??"elsewhere"]??"":""),g.mark(z&&s?z.hand:null);let q=i.opened.get()===e;je(m,"aria-expanded",String(q)),Mt(S,q),q||(y.hidden=!0,i.aiming.get()?.slot===e&&i.aiming.set(null));let H=Nt(i,"hand")&&s&&U==="here";for(let ee of Gm)g.allow(ee.value,H);v.disabled=!s||!i.connection.hasToken||n.slot===e,M.disabled=!s;let he=U==="stopped"||U==="gone"&&s,Y=!!R?.here&&R.alive===null;Mt(E,Y&&!!n.scene?.may.includes("expel")),E.disabled=!Nt(i,"expel"),Mt(_,!he&&!(s&&Y)),Mt(T,he),_.disabled=!Nt(i,"kill")||!s||U==="awaited",T.disabled=!Nt(i,"revive")||!s}}}function Hm(i){let{store:e}=i,t=k("span",{class:"panel-note"}),{element:n,body:s}=Ei("users","Users",k_,t),r=k("ul",{class:"users"}),o=Om("Remove");s.append(r);let a=[],l=()=>{for(let d of a)d.update();let u=e.scene?.users??[];Oe(t,u.length?`${u.filter(d=>["here","over"].includes(js(e.state,d.slot))).length} of ${u.length} here`:"")},c="",h=()=>{let u=e.scene,d=u?JSON.stringify([u.started,u.users,u.own,u.dimension]):"";if(d===c)return l();c=d,a=(u?.users??[]).map(f=>z_(i,f.slot,o)),r.replaceChildren(...a.map(f=>f.element)),l()};e.on("scene",h);for(let u of["state","slot","connection"])e.on(u,l);return i.opened.on(l),h(),n}var Wm="cotouch.keys",rd=["displacement","stress","plain"],V_=[["1 … 8","act as this user"],["G","grab the nearest point; arrows move it, Esc lets go"],["B","switch tools: grab, ball or blade"],["Shift","while holding a rigid tool: drag and wheel turn it"],["S","show copies overlaid or side by side"],["C","change what colours show"],["0","reset the view"],["F","freeze the plots"],["R","start or stop recording"],["I","invite"],["T","tour: ← → change steps, Esc leaves"],["D","change the theme"],["Tab, Enter","move to and open anything, including links"],["+ −","change the focused link’s delay"],["?","show these shortcuts"]];function G_(i){return i instanceof Element&&i.closest("input, textarea, select, [contenteditable]")!==null}function Xm(i,e){let{store:t}=i,n=!1;try{n=localStorage.getItem(Wm)==="off"}catch{}let s=k("input",{type:"checkbox"});s.checked=!n,s.addEventListener("change",()=>{n=!s.checked;try{localStorage.setItem(Wm,n?"off":"on")}catch{}});let r=_r("Keyboard",[k("dl",{class:"keys"},...V_.flatMap(([a,l])=>[k("dt",null,...a.split(" ").map(c=>c==="…"?" … ":k("kbd",null,c))),k("dd",null,l)])),k("label",{class:"check"},s,k("span",null,"Enable single-key shortcuts"))],[]),o={b:()=>t.set({tool:t.tools[(t.tools.indexOf(t.tool)+1)%t.tools.length]??"grab"}),s:()=>t.set({layout:t.settings.layout==="overlay"?"side":"overlay"}),c:()=>t.set({colour:rd[(rd.indexOf(t.colour)+1)%rd.length]??"plain"}),0:e.reset,f:e.freeze,r:e.record,i:e.invite,t:e.tour,d:()=>td(t)};return document.addEventListener("keydown",a=>{if(a.defaultPrevented||a.ctrlKey||a.metaKey||a.altKey||a.repeat||G_(a.target)||document.querySelector("dialog[open]"))return;if(a.key==="?")return a.preventDefault(),r.open();if(n)return;let l=Number(a.key)-1;if(a.key.length===1&&l>=0&&l<8){if(!t.scene?.own.includes(l)){t.scene?.users.some(c=>c.slot===l)&&i.say(`${Lt(t,l)} is moved from elsewhere; this page cannot act for that user.`,"warn");return}t.take(l),history.replaceState(null,"",kl(l)),i.say(`This page now acts as ${Lt(t,l)}.`);return}o[a.key.toLowerCase()]?.()}),{open:r.open}}var qm={x:180,y:126},H_=[.5,.42,.58,.34,.66,.28,.72];function $m(i){let[e,t]=i===2?[104,0]:[104,92];return Array.from({length:i},(n,s)=>{let r=2*Math.PI*s/i+(i===2?Math.PI:-Math.PI/2);return{x:qm.x+e*Math.cos(r),y:qm.y+t*Math.sin(r)}})}function Bl(i,e,t){return{x:i.x+(e.x-i.x)*t,y:i.y+(e.y-i.y)*t}}function Ym(i,e){let t=[];return i.map(([n,s])=>{let[r,o]=[e[n],e[s]];if(!r||!o)return .5;let a=.5,l=-1/0;for(let c of H_){let h=Bl(r,o,c),u=Math.min(40-40*Math.abs(c-.5),...t.map(d=>Math.hypot((h.x-d.x)*.62,(h.y-d.y)*1.5)),...e.map(d=>Math.hypot(h.x-d.x,h.y-d.y)-6));u>l+.5&&([l,a]=[u,c])}return t.push(Bl(r,o,a)),a})}function Jm(i,e){let t=new Set(i.slice(0,1));for(let n=!0;n;){n=!1;for(let[s,r]of e)t.has(s)!==t.has(r)&&(t.add(s).add(r),n=!0)}return i.filter(n=>!t.has(n))}function Km(i){return i.flatMap((e,t)=>i.slice(t+1).map(n=>e<n?[e,n]:[n,e]))}var od={start:"The links that the session started with.",best:"With these links, differences between copies fade fastest.",worst:"The same number of links, but differences fade slowest: watch the copies agree late.",yours:"Click the lines between users to link or unlink them, then apply."};function W_(i,e,t){for(let[n,s]of[[e,t],[t,e]]){let r=i.members[n]?.round_trips?.find(([a])=>a===s)?.[1],o=i.ends[`${n}-${s}`]?.round_trip??r;if(typeof o=="number")return Math.max(o,0)}return null}function Zm(i,e){let t=new Map,n=0;for(let[s,r]of e){let o=W_(i,s,r);if(o===null)return null;n+=o;for(let a of[s,r])t.set(a,(t.get(a)??0)+o)}return e.length?{mean:n/e.length,most:Math.max(...t.values())}:null}var ad=i=>(i[0]??"").toUpperCase()+i.slice(1);function zl(i,e){let t=new Set(i.map(Zn));return i.length===e.length&&e.every(n=>t.has(Zn(n)))}var va=i=>i.map(([e,t])=>ns(e,t));function jm(i,e,t,n){let{store:s}=i,r=!1,o=null,a=k("p",{class:"means"}),l=k("p",{class:"expected tabular"}),c=k("p",{class:"problem",role:"status",hidden:!0}),h=M=>M==="yours"?[...e].map(_=>_.split("-").map(Number)):va(s.state?.choices[M]??[]),u=M=>{if(r=M,e.clear(),M)for(let _ of va(s.state?.links??[]))e.add(Zn(_));t(M)},d=M=>{o=M,M==="yours"?r||u(!0):(r&&u(!1),i.act({what:"links",choice:M})),n()},f=M=>!!s.state&&M in s.state.choices,m=xr("Links",["start","best","worst","yours"].map(M=>({value:M,words:ad(M),tip:od[M]})),d),y=tt("Apply",()=>{let M=h("yours");i.act({what:"links",links:M}).then(_=>{_&&u(!1)})},{class:"button small primary"}),p=tt("Cancel",()=>{o=null,u(!1)},{class:"button small"}),g=k("div",{class:"actions",hidden:!0},y,p),v=()=>{let M=s.state,_=va(M?.links??[]);for(let I of["start","best","worst"]){let G=!f(I)&&Nt(i,"links");m.allow(I,Nt(i,"links")&&h(I).length>0),m.say(I,G?`${ad(I)} …`:ad(I),G?"Being computed; this takes a few seconds.":f(I)&&!h(I).length?"None found.":od[I])}m.allow("yours",Nt(i,"links"));let E=r?"yours":o&&o!=="yours"&&zl(h(o),_)?o:["start","best","worst"].find(I=>h(I).length&&zl(h(I),_))??(_.length?"yours":null);m.mark(E);let T=r?h("yours"):_,x=Nt(i,"links")&&!(f("best")&&f("worst")),S=Object.keys(M?.choices??{}).length>0;Mt(m.element,S||Nt(i,"links"));let O=E&&(S||r)?E==="yours"&&!r?"Your own links.":od[E]:"";Oe(a,x&&!r?`${O} Best and worst are being computed.`.trim():O);let[L,R]=M?[Zm(M,va(M.choices.start??M.links)),Zm(M,T)]:[null,null],U=T.length?`${T.length} ${T.length===1?"link":"links"}`:"";R&&(U+=`, mean round trip ${Gn(R.mean)}`),L&&R&&L.most>0&&!zl(T,va(M?.choices.start??[]))&&(U+=`. The user with the highest load needs about ${On(R.most/L.most,1)} × the initial damping, if all springs are equal`),Oe(l,U&&`${U}.`),Mt(g,r);let z=r?Jm((s.scene?.users??[]).map(I=>I.slot),T):[];Oe(c,z.length?`No path leads to ${z.map(I=>Lt(s,I)).join(", ")}.`:""),Mt(c,z.length>0),y.disabled=z.length>0||zl(T,_)||!Nt(i,"links"),je(m.element,"data-drafting",r?"":null)};return{element:k("div",{class:"topology",id:"topology"},m.element,a,l,c,g),update:v,changed:n}}var X_="Who is linked to whom. The number on a link is the age of its later end’s newest sample, and the share of samples lost. Select a link to see both ends and to delay, disturb or cut it; drag it sideways to change its delay (1 ms per pixel; on the keyboard, + and −).",Qm=.005,eg=.5,q_=100;function cd(i){let e=null,t=0,n=()=>{if(t=0,e===null)return;let s=e;e=null,t=window.setTimeout(n,q_),i(s)};return s=>{e=s,t||n()}}function $_(i,e,t,n,s){let{store:r}=i,[o,a]=e,[l,c]=[t[o]??{x:0,y:0},t[a]??{x:0,y:0}],h={x1:l.x,y1:l.y,x2:c.x,y2:c.y},u=Bl(l,c,n),d=nn("line",{...h,class:"link-line"}),f=nn("text",{x:u.x,y:u.y+3.5,class:"link-words"}),m=nn("rect",{class:"link-plate",rx:4,y:u.y-9,height:18}),y=nn("g",{class:"link",tabindex:0,role:"button","data-link":Zn(e)},nn("line",{...h,class:"link-halo"}),d,nn("line",{...h,class:"link-hit"}),m,f),p=()=>r.state?.emulated[`${o}-${a}`]?.delay??0,g=cd(x=>{i.act({what:"impair",a:o,b:a,delay:x},!0)}),v=null,M=null;y.addEventListener("pointerdown",x=>{s()||x.button!==0||(M={x:x.clientX,delay:p()},y.setPointerCapture(x.pointerId))}),y.addEventListener("pointermove",x=>{if(!M)return;let S=x.clientX-M.x;v===null&&(Math.abs(S)<4||!Nt(i,"impair"))||(v=Math.min(Math.max(M.delay+S*.001,0),eg),g(v),T())});let _=x=>{let S=v!==null,O=M!==null;M=v=null,!S&&O&&x.type==="pointerup"&&i.link.set(is(i.link.get(),e)?null:e),T()};y.addEventListener("pointerup",_),y.addEventListener("pointercancel",_);let E=0;y.addEventListener("keydown",x=>{if(!s()){if(x.key==="Enter"||x.key===" ")i.link.set(is(i.link.get(),e)?null:e),document.getElementById("link")?.focus();else if("+-=−".includes(x.key)&&Nt(i,"impair"))E=Math.min(Math.max(p()+(x.key==="+"||x.key==="="?Qm:-Qm),0),eg),g(E);else return;x.preventDefault(),x.stopPropagation()}});let T=()=>{let x=ws(r.state,o,a),S=Fi(r.state,o,a,"age"),O=Fi(r.state,o,a,"loss");je(y,"data-condition",x),je(y,"data-chosen",is(i.link.get(),e)?"":null),je(y,"data-drawn",v===null?null:"");let L=v!==null?`+${Gn(v)} each way`:x==="coupled"||x==="catching"||x==="guarded"?[S===null?"":Gn(Math.max(S,0)),O!==null&&O>=5e-4?xn(O):""].filter(Boolean).join(" · ")||"–":x==="waiting"?"":hi[x].words,R={guarded:"! ",cut:"✕ ",waiting:"… ",catching:"… "}[x]??"",U=v===null?(R+L).trim():L;Oe(f,U);let z=12+U.length*6.1;je(m,"x",(u.x-z/2).toFixed(1)),je(m,"width",z.toFixed(1)),je(y,"aria-label",`Link ${os(o,a)}, ${hi[x].words}, age ${Gn(S)}, loss ${xn(O)}`),je(y,"aria-pressed",String(is(i.link.get(),e)))};return{group:y,update:T}}function Y_(i,e,t){let{store:n}=i,s=Lt(n,e),r=Math.abs(t.x-360/2)>80,o=t.x>360/2,a=r?10:16,l=s.length>a?`${s.slice(0,a-1)}…`:s,c=r?{x:t.x+(o?1:-1)*24,y:t.y+4,anchor:o?"start":"end"}:{x:t.x,y:t.y+(t.y<248/2?-23:32),anchor:"middle"},h=nn("g",{class:"node",style:`--user:var(--user-${e});--on-user:var(--on-user-${e})`,"data-slot":e},nn("title",null,s),nn("circle",{cx:t.x,cy:t.y,r:20,class:"node-mine"}),nn("circle",{cx:t.x,cy:t.y,r:16,class:"node-disc"}),nn("text",{x:t.x,y:t.y+4.5,class:"node-number"},String(e+1)),nn("text",{x:c.x,y:c.y,"text-anchor":c.anchor,class:"node-name"},l));return h.addEventListener("click",()=>{i.opened.set(e),i.tab.set("users")}),{group:h,update:()=>{je(h,"data-presence",js(n.state,e)),je(h,"data-mine",n.me===e?"":null)}}}function J_(i,e,t,n){let[s,r]=[t[e[0]]??{x:0,y:0},t[e[1]]??{x:0,y:0}],o={x1:s.x,y1:s.y,x2:r.x,y2:r.y},a=Zn(e),l=nn("g",{class:"pair",tabindex:0,role:"checkbox","aria-label":`Link ${os(...e)}`,"data-link":a},nn("line",{...o,class:"pair-line"}),nn("line",{...o,class:"link-hit"})),c=()=>{i.delete(a)||i.add(a),n()};return l.addEventListener("click",c),l.addEventListener("keydown",h=>{h.key!=="Enter"&&h.key!==" "||(h.preventDefault(),c())}),{group:l,update:()=>je(l,"aria-checked",String(i.has(a)))}}function ng(i){let{store:e}=i,{element:t,body:n}=Ei("network","Network",X_),s=nn("svg",{viewBox:`0 0 ${360} ${248}`,class:"graph",role:"group","aria-label":"Users and links"}),r=k("ul",{class:"legend"},...["coupled","guarded","cut"].map(d=>k("li",{"data-condition":d,"data-tip":hi[d].means,tabindex:0},wn(hi[d].icon,12),hi[d].words))),o=new Set,a=!1,l=[],c="",h=()=>{let d=(e.scene?.users??[]).map(y=>y.slot),f=(e.state?.links??[]).map(([y,p])=>ns(y,p)),m=JSON.stringify([a,e.scene?.started,e.scene?.users,f]);if(m!==c){c=m;let y=document.activeElement?.closest("[data-link]")?.dataset.link,p=[];$m(d.length).forEach((_,E)=>{p[d[E]??E]=_});let g=Ym(f,p);l=[...a?Km(d).map(_=>J_(o,_,p,()=>u.changed())):f.map((_,E)=>$_(i,_,p,g[E]??.5,()=>a)),...d.map(_=>Y_(i,_,p[_]??{x:0,y:0}))],s.replaceChildren(...l.map(_=>_.group)),je(s,"data-drafting",a?"":null),y&&s.querySelector(`[data-link="${y}"]`)?.focus();let M=i.link.get();M&&!f.some(_=>is(_,M))&&i.link.set(null)}for(let y of l)y.update();u.update(),Mt(r,!a)},u=jm(i,o,d=>{a=d,d&&i.link.set(null),h()},()=>h());n.append(s,r,u.element);for(let d of["scene","state","slot","connection"])e.on(d,h);return i.link.on(h),h(),t}var hd=[{words:"state",tip:"State of this end’s spring",show:i=>hi[Ul(i)].words},{words:"age",tip:"Age of the newest sample in the last step, up to the offset between the two clocks",show:i=>Gn(i.age)},{words:"age sum",tip:"Largest recent sum of the ages at both ends, in which clock offsets cancel",show:i=>Gn(i.age_sum)},{words:"budget",tip:"Largest sum of ages that the damping covers",show:i=>Gn(i.budget)},{words:"path",tip:"Shortest round trip, and whether the path is direct or relayed",show:i=>`${Gn(i.round_trip)} ${i.path_state}`},{words:"loss",tip:"Share of the neighbour’s samples that did not arrive",show:i=>xn(i.loss)},{words:"samples",tip:"Samples sent to the neighbour per second",show:i=>Dl(i.rate)},{words:"data",tip:"Data and datagrams sent to the neighbour per second, and what the perceptual codec saved",show:i=>`${rs(i.byte_rate,"B/s")} in ${On(i.datagram_rate)}${i.saved>0?`, ${xn(i.saved,0)} saved`:""}`},{words:"force",tip:"Force of the link’s spring on this copy",show:i=>Nl(i.force)},{words:"work",tip:"Work of the link on this copy since the start",show:i=>rs(i.work,"J")},{words:"apart",tip:"Largest difference between the copies, as far as known",show:i=>Am(i.difference)},{words:"guarded",tip:"How often the link was guarded",show:i=>`${ya(i.guarded)} ×`}];function ud(i,e,t,n){let s=k("output",{class:"tabular"},t.show(0)),r=k("input",{type:"range",min:0,max:t.most,step:t.step,value:0,"aria-label":i}),o=-1/0,a=cd(n),l=()=>{let c=Number(r.value);Oe(s,t.show(c)),je(r,"aria-valuetext",t.show(c)),r.style.setProperty("--share",`${100*c/t.most}%`)};return r.addEventListener("input",()=>{o=performance.now(),l(),a(Number(r.value))}),{element:k("label",{class:"slider","data-tip":e},k("span",null,i),r,s),set(c){performance.now()-o<1e3||Number(r.value)===c||(r.value=String(c),l())},enable(c){r.disabled=!c}}}function ig(i){let{store:e}=i,t=[0,1],n=k("h2",{id:"link-title",class:"tabular"}),s=wn("good",14),r=k("strong",null),o=k("span",{class:"means"}),a=k("p",{class:"expected tabular"}),l=v=>M=>{i.act({what:"impair",a:t[0],b:t[1],[v]:M},!0)},c={delay:ud("delay","Added to every sample, each way",{most:.5,step:.005,show:Gn},l("delay")),jitter:ud("jitter","Scale of the random part of the delay",{most:.1,step:.002,show:Gn},l("jitter")),loss:ud("loss","Share of samples dropped",{most:.5,step:.01,show:v=>xn(v,0)},l("loss"))},h=tt("Cut",()=>{let v=!(e.state&&no(e.state,...t));i.act({what:"cut",a:t[0],b:t[1],on:v})},{icon:"cut",class:"button",id:"cut"}),u=tt("Clear",()=>{i.act({what:"impair",a:t[0],b:t[1],delay:0,jitter:0,loss:0})},{class:"button",icon:"reset",tip:"No added delay, jitter or loss"}),d=[k("th",{scope:"col"}),k("th",{scope:"col"})],f=hd.map(()=>[k("td"),k("td")]),m=k("table",{class:"numbers"},k("thead",null,k("tr",null,k("td"),...d)),k("tbody",null,...hd.map((v,M)=>k("tr",null,k("th",{scope:"row","data-tip":v.tip,tabindex:0},v.words),...f[M]??[])))),y=tt("",()=>i.link.set(null),{icon:"close",class:"button bare",label:"Close the link’s card"}),p=k("aside",{id:"link",class:"card","aria-labelledby":"link-title",tabindex:-1,hidden:!0},k("div",{class:"panel-head"},n,k("div",{class:"grow"}),y),k("p",{class:"condition"},s,r," ",o),a,c.delay.element,c.jitter.element,c.loss.element,k("div",{class:"actions"},h,u),m);p.addEventListener("keydown",v=>{if(v.key!=="Escape")return;let M=document.querySelector(`.link[data-link="${t.join("-")}"]`);i.link.set(null),M?.focus(),v.stopPropagation()});let g=()=>{let v=i.link.get();if(Mt(p,v!==null),!v)return;t=v;let[M,_]=t,E=ws(e.state,M,_);Oe(n,`Link ${os(M,_)}`),je(p,"data-condition",E),Vn(s,hi[E].icon),Oe(r,hi[E].words),Oe(o,km(e.state,M,_));let T=Ol(e.state,M,_);Oe(a,T===null||E==="cut"?"":T>=0?`${xn(T,0)} of the age budget to spare.`:`Ages are ${xn(-T,0)} over budget.`);let x=e.state?.emulated[`${M}-${_}`];c.delay.set(x?.delay??0),c.jitter.set(x?.jitter??0),c.loss.set(x?.loss??0);for(let L of Object.values(c))L.enable(Nt(i,"impair"));u.disabled=!Nt(i,"impair");let S=!!e.state&&no(e.state,M,_);Oe(h.lastElementChild??h,S?"Reconnect":"Cut");let O=h.querySelector("svg");O&&Vn(O,S?"mend":"cut"),je(h,"class",S?"button primary":"button danger"),h.disabled=!Nt(i,"cut"),[[M,_],[_,M]].forEach(([L,R],U)=>{let z=d[U];z&&(Oe(z,`at ${(L??0)+1}`),je(z,"title",Lt(e,L??0)),z.style.setProperty("--user",`var(--user-${L})`));let I=e.state?.ends[`${L}-${R}`];hd.forEach((G,q)=>{let H=f[q]?.[U];H&&Oe(H,I?G.show(I):"–")})})};return e.on("state",g),e.on("scene",g),e.on("connection",g),i.link.on(v=>{g(),v&&(p.scrollTop=0)}),p}var K_="uplot",Z_="u-hz",j_="u-vt",Q_="u-title",eb="u-wrap",tb="u-under",nb="u-over",ib="u-axis",Sr="u-off",sb="u-select",rb="u-cursor-x",ob="u-cursor-y",ab="u-cursor-pt",lb="u-legend",cb="u-live",hb="u-inline",ub="u-series",db="u-marker",sg="u-label",fb="u-value",ba="width",Ma="height";var rg="bottom",io="left",dd="right",Rd="#000",og=Rd+"0",fd="mousemove",ag="mousedown",pd="mouseup",lg="mouseenter",cg="mouseleave",hg="dblclick",pb="resize",mb="scroll",ug="change",Xl="dppxchange",Pd="--",ho=typeof window<"u",xd=ho?document:null,ro=ho?window:null,gb=ho?navigator:null,Ut,Vl;function _d(){let i=devicePixelRatio;Ut!=i&&(Ut=i,Vl&&Md(ug,Vl,_d),Vl=matchMedia(`(min-resolution: ${Ut-.001}dppx) and (max-resolution: ${Ut+.001}dppx)`),wr(ug,Vl,_d),ro.dispatchEvent(new CustomEvent(Xl)))}function ui(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function bd(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function jt(i,e,t){i.style[e]=t+"px"}function Ui(i,e,t,n){let s=xd.createElement(i);return e!=null&&ui(s,e),t?.insertBefore(s,n),s}function Ai(i,e){return Ui("div",i,e)}var dg=new WeakMap;function ls(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=dg.get(i);r!=o&&(i.style.transform=r,dg.set(i,r),e<0||t<0||e>n||t>s?ui(i,Sr):bd(i,Sr))}var fg=new WeakMap;function pg(i,e,t){let n=e+t,s=fg.get(i);n!=s&&(fg.set(i,n),i.style.background=e,i.style.borderColor=t)}var mg=new WeakMap;function gg(i,e,t,n){let s=e+""+t,r=mg.get(i);s!=r&&(mg.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Id={passive:!0},yb={...Id,capture:!0};function wr(i,e,t,n){e.addEventListener(i,t,n?yb:Id)}function Md(i,e,t,n){e.removeEventListener(i,t,Id)}ho&&_d();function Oi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:di((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Wg(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var Xg=i=>i!=null,qg=i=>i!=null&&i>0,Yl=Wg(Xg),vb=Wg(qg);function xb(i,e,t,n=0,s=!1){let r=s?vb:Yl,o=s?qg:Xg;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Xt,l??-Xt]}function Jl(i,e,t,n){let s=xg(i),r=xg(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Es:$g,a=s==1?di:Ci,l=r==1?Ci:di,c=a(o(Tn(i))),h=l(o(Tn(e))),u=oo(t,c),d=oo(t,h);return t==10&&(c<0&&(u=qt(u,-c)),h<0&&(d=qt(d,-h))),n||t==2?(i=u*s,e=d*r):(i=Zg(i,u),e=Kl(e,d)),[i,e]}function Ld(i,e,t,n){let s=Jl(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Nd=.1,yg={mode:3,pad:Nd},wa={pad:0,soft:null,mode:0},_b={min:wa,max:wa};function ql(i,e,t,n){return Zl(t)?vg(i,e,t):(wa.pad=t,wa.soft=n?0:null,wa.mode=n?3:0,vg(i,e,_b))}function Dt(i,e){return i??e}function bb(i,e,t){for(e=Dt(e,0),t=Dt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function vg(i,e,t){let n=t.min,s=t.max,r=Dt(n.pad,0),o=Dt(s.pad,0),a=Dt(n.hard,-Xt),l=Dt(s.hard,Xt),c=Dt(n.soft,Xt),h=Dt(s.soft,-Xt),u=Dt(n.mode,0),d=Dt(s.mode,0),f=e-i,m=Es(f),y=jn(Tn(i),Tn(e)),p=Es(y),g=Tn(p-m);(f<1e-24||g>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=Xt&&(r=0),d==2&&h!=-Xt&&(o=0)));let v=f||y||1e3,M=Es(v),_=oo(10,di(M)),E=v*(f==0?i==0?.1:1:r),T=qt(Zg(i-E,_/10),24),x=i>=c&&(u==1||u==3&&T<=c||u==2&&T>=c)?c:Xt,S=jn(a,T<x&&i>=x?x:ki(x,T)),O=v*(f==0?e==0?.1:1:o),L=qt(Kl(e+O,_/10),24),R=e<=h&&(d==1||d==3&&L>=h||d==2&&L<=h)?h:-Xt,U=ki(l,L>R&&e<=R?R:jn(R,L));return S==U&&S==0&&(U=100),[S,U]}var Mb=new Intl.NumberFormat(ho?gb.language:"en-US"),Dd=i=>Mb.format(i),fi=Math,Wl=fi.PI,Tn=fi.abs,di=fi.floor,En=fi.round,Ci=fi.ceil,ki=fi.min,jn=fi.max,oo=fi.pow,xg=fi.sign,Es=fi.log10,$g=fi.log2,Sb=(i,e=1)=>fi.sinh(i)*e,md=(i,e=1)=>fi.asinh(i/e),Xt=1/0;function _g(i){return(Es((i^i>>31)-(i>>31))|0)+1}function Sd(i,e,t){return ki(jn(i,e),t)}function Yg(i){return typeof i=="function"}function Ct(i){return Yg(i)?i:()=>i}var wb=()=>{},Jg=i=>i,Kg=(i,e)=>e,Eb=i=>null,bg=i=>!0,Mg=(i,e)=>i==e,Tb=/\.\d*?(?=9{6,}|0{6,})/gm,Er=i=>{if(Qg(i)||er.has(i))return i;let e=`${i}`,t=e.match(Tb);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Er(s)}e${r}`}return qt(i,n)};function br(i,e){return Er(qt(Er(i/e))*e)}function Kl(i,e){return Er(Ci(Er(i/e))*e)}function Zg(i,e){return Er(di(Er(i/e))*e)}function qt(i,e=0){if(Qg(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return En(n)/t}var er=new Map;function jg(i){return((""+i).split(".")[1]||"").length}function Ta(i,e,t,n){let s=[],r=n.map(jg);for(let o=e;o<t;o++){let a=Tn(o),l=qt(oo(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:qt(h,u);s.push(d),er.set(d,u)}}return s}var Ea={},Fd=[],ao=[null,null],Qs=Array.isArray,Qg=Number.isInteger,Ab=i=>i===void 0;function Sg(i){return typeof i=="string"}function Zl(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function Cb(i){return i!=null&&typeof i=="object"}var Rb=Object.getPrototypeOf(Uint8Array),e0="__proto__";function lo(i,e=Zl){let t;if(Qs(i)){let n=i.find(s=>s!=null);if(Qs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=lo(i[s],e)}else t=i.slice()}else if(i instanceof Rb)t=i.slice();else if(e(i)){t={};for(let n in i)n!=e0&&(t[n]=lo(i[n],e))}else t=i;return t}function _n(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=e0&&(Zl(i[s])?_n(i[s],lo(n[s])):i[s]=lo(n[s]))}return i}var Pb=0,Ib=1,Lb=2;function Nb(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function Db(i,e){if(Ob(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return kb(o[0])||(o=Ub(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:Ib,f=[];for(let m=0;m<h.length;m++){let y=h[m],p=r.get(l[m]);y===null?d!=Pb&&(u[p]=y,d==Lb&&f.push(p)):u[p]=y}Nb(u,f,s),n.push(u)}}return n}var Fb=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Ub(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function Ob(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function kb(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=jn(1,di((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var t0=["January","February","March","April","May","June","July","August","September","October","November","December"],n0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function i0(i){return i.slice(0,3)}var Bb=n0.map(i0),zb=t0.map(i0),Vb={MMMM:t0,MMM:zb,WWWW:n0,WWW:Bb};function _a(i){return(i<10?"0":"")+i}function Gb(i){return(i<10?"00":i<100?"0":"")+i}var Hb={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>_a(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>_a(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>_a(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>_a(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>_a(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Gb(i.getMilliseconds())};function Ud(i,e){e=e||Vb;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?Hb[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Wb=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Xb(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==Wb?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var s0=i=>i%1==0,$l=[1,2,2.5,5],qb=Ta(10,-32,0,$l),r0=Ta(10,0,32,$l),$b=r0.filter(s0),Mr=qb.concat(r0),Od=`
`,o0="{YYYY}",wg=Od+o0,a0="{M}/{D}",Sa=Od+a0,Gl=Sa+"/{YY}",l0="{aa}",Yb="{h}:{mm}",so=Yb+l0,Eg=Od+so,Tg=":{ss}",kt=null;function c0(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?Ta(10,0,3,$l).filter(s0):Ta(10,-3,0,$l)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,o0,kt,kt,kt,kt,kt,kt,1],[s*28,"{MMM}",wg,kt,kt,kt,kt,kt,1],[s,a0,wg,kt,kt,kt,kt,kt,1],[n,"{h}"+l0,Gl,kt,Sa,kt,kt,kt,1],[t,so,Gl,kt,Sa,kt,kt,kt,1],[e,Tg,Gl+" "+so,kt,Sa+" "+so,kt,Eg,kt,1],[i,Tg+".{fff}",Gl+" "+so,kt,Sa+" "+so,kt,Eg,kt,1]];function h(u){return(d,f,m,y,p,g)=>{let v=[],M=p>=o,_=p>=r&&p<o,E=u(m),T=qt(E*i,3),x=gd(E.getFullYear(),M?0:E.getMonth(),_||M?1:E.getDate()),S=qt(x*i,3);if(_||M){let O=_?p/r:0,L=M?p/o:0,R=T==S?T:qt(gd(x.getFullYear()+L,x.getMonth()+O,1)*i,3),U=new Date(En(R/i)),z=U.getFullYear(),I=U.getMonth();for(let G=0;R<=y;G++){let q=gd(z+L*G,I+O*G,1),H=q-u(qt(q*i,3));R=qt((+q+H)*i,3),R<=y&&v.push(R)}}else{let O=p>=s?s:p,L=di(m)-di(T),R=S+L+Kl(T-S,O);v.push(R);let U=u(R),z=U.getHours()+U.getMinutes()/t+U.getSeconds()/n,I=p/n,G=d.axes[f]._space,q=g/G;for(;R=qt(R+p,i==1?0:3),!(R>y);)if(I>1){let H=di(qt(z+I,6))%24,ee=u(R).getHours()-H;ee>1&&(ee=-1),R-=ee*n,z=(z+I)%24;let J=v[v.length-1];qt((R-J)/p,3)*q>=.7&&v.push(R)}else v.push(R)}return v}}return[l,c,h]}var[Jb,Kb,Zb]=c0(1),[jb,Qb,eM]=c0(.001);Ta(2,-53,53,[1]);function Ag(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Cg(i,e){return(t,n,s,r,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,h,u,d,f;return n.map(m=>{let y=i(m),p=y.getFullYear(),g=y.getMonth(),v=y.getDate(),M=y.getHours(),_=y.getMinutes(),E=y.getSeconds(),T=p!=l&&a[2]||g!=c&&a[3]||v!=h&&a[4]||M!=u&&a[5]||_!=d&&a[6]||E!=f&&a[7]||a[1];return l=p,c=g,h=v,u=M,d=_,f=E,T(y)})}}function tM(i,e){let t=Ud(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function gd(i,e,t){return new Date(i,e,t)}function Rg(i,e){return e(i)}var nM="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Pg(i,e){return(t,n,s,r)=>r==null?Pd:e(i(n))}function iM(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function sM(i,e){return i.series[e].fill(i,e)}var rM={show:!0,live:!0,isolate:!1,mount:wb,markers:{show:!0,width:2,stroke:iM,fill:sM,dash:"solid"},idx:null,idxs:null,values:[]};function oM(i,e){let t=i.cursor.points,n=Ai(),s=t.size(i,e);jt(n,ba,s),jt(n,Ma,s);let r=s/-2;jt(n,"marginLeft",r),jt(n,"marginTop",r);let o=t.width(i,e,s);return o&&jt(n,"borderWidth",o),n}function aM(i,e){let t=i.series[e].points;return t._fill||t._stroke}function lM(i,e){let t=i.series[e].points;return t._stroke||t._fill}function cM(i,e){return i.series[e].points.size}var yd=[0,0];function hM(i,e,t){return yd[0]=e,yd[1]=t,yd}function Hl(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function vd(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var uM={show:!0,x:!0,y:!0,lock:!1,move:hM,points:{one:!1,show:oM,size:cM,width:0,stroke:lM,fill:aM},bind:{mousedown:Hl,mouseup:Hl,click:Hl,dblclick:Hl,mousemove:vd,mouseleave:vd,mouseenter:vd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},h0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},kd=_n({},h0,{filter:Kg}),u0=_n({},kd,{size:10}),d0=_n({},h0,{show:!1}),Bd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',f0="bold "+Bd,p0=1.5,Ig={show:!0,scale:"x",stroke:Rd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:f0,side:2,grid:kd,ticks:u0,border:d0,font:Bd,lineGap:p0,rotate:0},dM="Value",fM="Time",Lg={show:!0,scale:"x",auto:!1,sorted:1,min:Xt,max:-Xt,idxs:[]};function pM(i,e,t,n,s){return e.map(r=>r==null?"":Dd(r))}function mM(i,e,t,n,s,r,o){let a=[],l=er.get(s)||0;t=o?t:qt(Kl(t,s),l);for(let c=t;c<=n;c=qt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function wd(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?Es:$g,h=di(c(t));s=oo(l,h),l==10&&(s=Mr[Oi(s,Mr)]);let u=t,d=s*l;l==10&&(d=Mr[Oi(d,Mr)]);do a.push(u),u=u+s,l==10&&!er.has(u)&&(u=qt(u,er.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Mr[Oi(d,Mr)]));while(u<=n);return a}function gM(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?wd(i,e,jn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?wd(i,e,jn(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var m0=/./,yM=/[12357]/,vM=/[125]/,Ng=/1/,Ed=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function xM(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?m0:l(7,o)-h>=c?yM:l(5,o)-h>=c?vM:Ng;if(u==Ng){let d=Tn(l(1,o)-h);if(d<c)return Ed(e.slice().reverse(),a.distr,u,Ci(c/d)).reverse()}return Ed(e,a.distr,u,1)}function _M(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=Tn(l(1,o)-l(2,o));return c<a?Ed(e.slice().reverse(),3,m0,Ci(a/c)).reverse():e}function bM(i,e,t,n){return n==null?Pd:e==null?"":Dd(e)}var Dg={show:!0,scale:"y",stroke:Rd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:f0,side:3,grid:kd,ticks:u0,border:d0,font:Bd,lineGap:p0,rotate:0};function MM(i,e){let t=3+(i||1)*2;return qt(t*e,3)}function SM(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=Tn(o-r),l=i.series[e],c=a/(l.points.space*Ut);return n[1]-n[0]<=c}var Fg={scale:null,auto:!0,sorted:0,min:Xt,max:-Xt},g0=(i,e,t,n,s)=>s,Ug={show:!0,auto:!0,sorted:0,gaps:g0,alpha:1,facets:[_n({},Fg,{scale:"x"}),_n({},Fg,{scale:"y"})]},Og={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:g0,alpha:1,points:{show:SM,filter:null},values:null,min:Xt,max:-Xt,idxs:[],path:null,clip:null};function wM(i,e,t,n,s){return t/10}var y0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},EM=_n({},y0,{time:!1,ori:1}),kg={};function v0(i,e){let t=kg[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(kg[i]=t)),t}var co=1,Td=2;function Tr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,m=a.width,y=a.height,p=i.valToPosH,g=i.valToPosV;return h.ori==0?t(s,l,c,h,u,p,g,d,f,m,y,Ql,uo,tc,_0,M0):t(s,l,c,h,u,g,p,f,d,y,m,ec,fo,Gd,b0,S0)}function zd(i,e){let t=0,n=0,s=Dt(i.bands,Fd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function TM(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ts(i,e,t,n,s,r){return Tr(i,e,(o,a,l,c,h,u,d,f,m,y,p)=>{let g=o.pxRound,v=c.dir*(c.ori==0?1:-1),M=c.ori==0?uo:fo,_,E;v==1?(_=t,E=n):(_=n,E=t);let T=g(u(a[_],c,y,f)),x=g(d(l[_],h,p,m)),S=g(u(a[E],c,y,f)),O=g(d(r==1?h.max:h.min,h,p,m)),L=new Path2D(s);return M(L,S,O),M(L,T,O),M(L,T,x),L})}function jl(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?tc:Gd,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function AM(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Vd(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[u]),m=d==u?f:r(i[d]),y=u-s;f=o<=0&&y>=0&&y<l?r(i[y]):f;let g=d+s;m=o>=0&&g>=0&&g<l?r(i[g]):m,m>=f&&a.push([f,m])}return a}function Bg(i){return i==0?Jg:i==1?En:e=>br(e,i)}function x0(i){let e=i==0?Ql:ec,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=ki(c,a/2,l/2),h=ki(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Ql=(i,e,t)=>{i.moveTo(e,t)},ec=(i,e,t)=>{i.moveTo(t,e)},uo=(i,e,t)=>{i.lineTo(e,t)},fo=(i,e,t)=>{i.lineTo(t,e)},tc=x0(0),Gd=x0(1),_0=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},b0=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},M0=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},S0=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function w0(i){return(e,t,n,s,r)=>Tr(e,t,(o,a,l,c,h,u,d,f,m,y,p)=>{let{pxRound:g,points:v}=o,M,_;c.ori==0?(M=Ql,_=_0):(M=ec,_=b0);let E=qt(v.width*Ut,3),T=(v.size-v.width)/2*Ut,x=qt(T*2,3),S=new Path2D,O=new Path2D,{left:L,top:R,width:U,height:z}=e.bbox;tc(O,L-x,R-x,U+x*2,z+x*2);let I=G=>{if(l[G]!=null){let q=g(u(a[G],c,y,f)),H=g(d(l[G],h,p,m));M(S,q+T,H),_(S,q,H,T,0,Wl*2)}};if(r)r.forEach(I);else for(let G=n;G<=s;G++)I(G);return{stroke:E>0?S:null,fill:S,clip:O,flags:co|Td}})}function E0(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var CM=E0(uo),RM=E0(fo);function T0(i){let e=Dt(i?.alignGaps,0);return(t,n,s,r)=>Tr(t,n,(o,a,l,c,h,u,d,f,m,y,p)=>{[s,r]=Yl(l,s,r);let g=o.pxRound,v=z=>g(u(z,c,y,f)),M=z=>g(d(z,h,p,m)),_,E;c.ori==0?(_=uo,E=CM):(_=fo,E=RM);let T=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:co},S=x.stroke,O=!1;if(r-s>=y*4){let z=re=>t.posToVal(re,c.key,!0),I=null,G=null,q,H,he,Y=v(a[T==1?s:r]),ee=v(a[s]),J=v(a[r]),ae=z(T==1?ee+1:J-1);for(let re=T==1?s:r;re>=s&&re<=r;re+=T){let Q=a[re],ye=(T==1?Q<ae:Q>ae)?Y:v(Q),Ae=l[re];ye==Y?Ae!=null?(H=Ae,I==null?(_(S,ye,M(H)),q=I=G=H):H<I?I=H:H>G&&(G=H)):Ae===null&&(O=!0):(I!=null&&E(S,Y,M(I),M(G),M(q),M(H)),Ae!=null?(H=Ae,_(S,ye,M(H)),I=G=q=H):(I=G=null,Ae===null&&(O=!0)),Y=ye,ae=z(Y+T))}I!=null&&I!=G&&he!=Y&&E(S,Y,M(I),M(G),M(q),M(H))}else for(let z=T==1?s:r;z>=s&&z<=r;z+=T){let I=l[z];I===null?O=!0:I!=null&&_(S,v(a[z]),M(I))}let[R,U]=zd(t,n);if(o.fill!=null||R!=0){let z=x.fill=new Path2D(S),I=o.fillTo(t,n,o.min,o.max,R),G=M(I),q=v(a[s]),H=v(a[r]);T==-1&&([H,q]=[q,H]),_(z,H,G),_(z,q,G)}if(!o.spanGaps){let z=[];O&&z.push(...Vd(a,l,s,r,T,v,e)),x.gaps=z=o.gaps(t,n,s,r,z),x.clip=jl(z,c.ori,f,m,y,p)}return U!=0&&(x.band=U==2?[Ts(t,n,s,r,S,-1),Ts(t,n,s,r,S,1)]:Ts(t,n,s,r,S,U)),x})}function PM(i){let e=Dt(i.align,1),t=Dt(i.ascDesc,!1),n=Dt(i.alignGaps,0),s=Dt(i.extend,!1);return(r,o,a,l)=>Tr(r,o,(c,h,u,d,f,m,y,p,g,v,M)=>{[a,l]=Yl(u,a,l);let _=c.pxRound,{left:E,width:T}=r.bbox,x=ee=>_(m(ee,d,v,p)),S=ee=>_(y(ee,f,M,g)),O=d.ori==0?uo:fo,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:co},R=L.stroke,U=d.dir*(d.ori==0?1:-1),z=S(u[U==1?a:l]),I=x(h[U==1?a:l]),G=I,q=I;s&&e==-1&&(q=E,O(R,q,z)),O(R,I,z);for(let ee=U==1?a:l;ee>=a&&ee<=l;ee+=U){let J=u[ee];if(J==null)continue;let ae=x(h[ee]),re=S(J);e==1?O(R,ae,z):O(R,G,re),O(R,ae,re),z=re,G=ae}let H=G;s&&e==1&&(H=E+T,O(R,H,z));let[he,Y]=zd(r,o);if(c.fill!=null||he!=0){let ee=L.fill=new Path2D(R),J=c.fillTo(r,o,c.min,c.max,he),ae=S(J);O(ee,H,ae),O(ee,q,ae)}if(!c.spanGaps){let ee=[];ee.push(...Vd(h,u,a,l,U,x,n));let J=c.width*Ut/2,ae=t||e==1?J:-J,re=t||e==-1?-J:J;ee.forEach(Q=>{Q[0]+=ae,Q[1]+=re}),L.gaps=ee=c.gaps(r,o,a,l,ee),L.clip=jl(ee,d.ori,p,g,v,M)}return Y!=0&&(L.band=Y==2?[Ts(r,o,a,l,R,-1),Ts(r,o,a,l,R,1)]:Ts(r,o,a,l,R,Y)),L})}function zg(i,e,t,n,s,r,o=Xt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=Tn(i[l]-i[a]);h<c&&(c=h,o=Tn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function IM(i){i=i||Ea;let e=Dt(i.size,[.6,Xt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Ct(s),o=1-e[0],a=Dt(e[1],Xt),l=Dt(e[2],1),c=Dt(i.disp,Ea),h=Dt(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,m,y,p)=>Tr(f,m,(g,v,M,_,E,T,x,S,O,L,R)=>{let U=g.pxRound,z=t,I=n*Ut,G=a*Ut,q=l*Ut,H,he;_.ori==0?[H,he]=r(f,m):[he,H]=r(f,m);let Y=_.dir*(_.ori==0?1:-1),ee=_.ori==0?tc:Gd,J=_.ori==0?h:(be,qe,dt,we,Ot,Je,nt)=>{h(be,qe,dt,Ot,we,nt,Je)},ae=Dt(f.bands,Fd).find(be=>be.series[0]==m),re=ae!=null?ae.dir:0,Q=g.fillTo(f,m,g.min,g.max,re),pe=U(x(Q,E,R,O)),ye,Ae,Se,He=L,ot=U(g.width*Ut),Ze=!1,at=null,rt=null,le=null,xe=null;u!=null&&(ot==0||d!=null)&&(Ze=!0,at=u.values(f,m,y,p),rt=new Map,new Set(at).forEach(be=>{be!=null&&rt.set(be,new Path2D)}),ot>0&&(le=d.values(f,m,y,p),xe=new Map,new Set(le).forEach(be=>{be!=null&&xe.set(be,new Path2D)})));let{x0:ve,size:Be}=c;if(ve!=null&&Be!=null){z=1,v=ve.values(f,m,y,p),ve.unit==2&&(v=v.map(dt=>f.posToVal(S+dt*L,_.key,!0)));let be=Be.values(f,m,y,p);Be.unit==2?Ae=be[0]*L:Ae=T(be[0],_,L,S)-T(0,_,L,S),He=zg(v,M,T,_,L,S,He),Se=He-Ae+I}else He=zg(v,M,T,_,L,S,He),Se=He*o+I,Ae=He-Se;Se<1&&(Se=0),ot>=Ae/2&&(ot=0),Se<5&&(U=Jg);let Le=Se>0,st=He-Se-(Le?ot:0);Ae=U(Sd(st,q,G)),ye=(z==0?Ae/2:z==Y?0:Ae)-z*Y*((z==0?I/2:0)+(Le?ot/2:0));let ze={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},yt=Ze?null:new Path2D,pt=null;if(ae!=null)pt=f.data[ae.series[1]];else{let{y0:be,y1:qe}=c;be!=null&&qe!=null&&(M=qe.values(f,m,y,p),pt=be.values(f,m,y,p))}let xt=H*Ae,B=he*Ae;for(let be=Y==1?y:p;be>=y&&be<=p;be+=Y){let qe=M[be];if(qe==null)continue;if(pt!=null){let $=pt[be]??0;if(qe-$==0)continue;pe=x($,E,R,O)}let dt=_.distr!=2||c!=null?v[be]:be,we=T(dt,_,L,S),Ot=x(Dt(qe,Q),E,R,O),Je=U(we-ye),nt=U(jn(Ot,pe)),P=U(ki(Ot,pe)),w=nt-P;if(qe!=null){let $=qe<0?B:xt,fe=qe<0?xt:B;Ze?(ot>0&&le[be]!=null&&ee(xe.get(le[be]),Je,P+di(ot/2),Ae,jn(0,w-ot),$,fe),at[be]!=null&&ee(rt.get(at[be]),Je,P+di(ot/2),Ae,jn(0,w-ot),$,fe)):ee(yt,Je,P+di(ot/2),Ae,jn(0,w-ot),$,fe),J(f,m,be,Je-ot/2,P,Ae+ot,w)}}return ot>0?ze.stroke=Ze?xe:yt:Ze||(ze._fill=g.width==0?g._fill:g._stroke??g._fill,ze.width=0),ze.fill=Ze?rt:yt,ze})}function LM(i,e){let t=Dt(e?.alignGaps,0);return(n,s,r,o)=>Tr(n,s,(a,l,c,h,u,d,f,m,y,p,g)=>{[r,o]=Yl(c,r,o);let v=a.pxRound,M=H=>v(d(H,h,p,m)),_=H=>v(f(H,u,g,y)),E,T,x;h.ori==0?(E=Ql,x=uo,T=M0):(E=ec,x=fo,T=S0);let S=h.dir*(h.ori==0?1:-1),O=M(l[S==1?r:o]),L=O,R=[],U=[];for(let H=S==1?r:o;H>=r&&H<=o;H+=S)if(c[H]!=null){let Y=l[H],ee=M(Y);R.push(L=ee),U.push(_(c[H]))}let z={stroke:i(R,U,E,x,T,v),fill:null,clip:null,band:null,gaps:null,flags:co},I=z.stroke,[G,q]=zd(n,s);if(a.fill!=null||G!=0){let H=z.fill=new Path2D(I),he=a.fillTo(n,s,a.min,a.max,G),Y=_(he);x(H,L,Y),x(H,O,Y)}if(!a.spanGaps){let H=[];H.push(...Vd(l,c,r,o,S,M,t)),z.gaps=H=a.gaps(n,s,r,o,H),z.clip=jl(H,h.ori,m,y,p,g)}return q!=0&&(z.band=q==2?[Ts(n,s,r,o,I,-1),Ts(n,s,r,o,I,1)]:Ts(n,s,r,o,I,q)),z})}function NM(i){return LM(DM,i)}function DM(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var Ad=new Set;function Vg(){for(let i of Ad)i.syncRect(!0)}ho&&(wr(pb,ro,Vg),wr(mb,ro,Vg,!0),wr(Xl,ro,()=>{kn.pxRatio=Ut}));var FM=T0(),UM=w0();function Gg(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Cd(r,o,e,t))}function OM(i,e){return i.map((t,n)=>n==0?{}:_n({},e,t))}function Cd(i,e,t,n){return _n({},e==0?t:n,i)}function A0(i,e,t){return e==null?ao:[e,t]}var kM=A0;function BM(i,e,t){return e==null?ao:ql(e,t,Nd,!0)}function C0(i,e,t,n){return e==null?ao:Jl(e,t,i.scales[n].log,!1)}var zM=C0;function R0(i,e,t,n){return e==null?ao:Ld(e,t,i.scales[n].log,!1)}var VM=R0;function GM(i,e,t,n,s){let r=jn(_g(i),_g(e)),o=e-i,a=Oi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?er.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Hg(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=En((t=+s)*Ut))+"px"),[i,e,t]}function HM(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=qt(e[2]*Ut,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function kn(i,e,t){let n={mode:Dt(i.mode,1)},s=n.mode;function r(b,A,N,D){let X=A.valToPct(b);return D+N*(A.dir==-1?1-X:X)}function o(b,A,N,D){let X=A.valToPct(b);return D+N*(A.dir==-1?X:1-X)}function a(b,A,N,D){return A.ori==0?r(b,A,N,D):o(b,A,N,D)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Ai(K_);if(i.id!=null&&(c.id=i.id),ui(c,i.class),i.title){let b=Ai(Q_,c);b.textContent=i.title}let h=Ui("canvas"),u=n.ctx=h.getContext("2d"),d=Ai(eb,c);wr("click",d,b=>{b.target===m&&(Jt!=Jr||tn!=Kr)&&Un.click(n,b)},!0);let f=n.under=Ai(tb,d);d.appendChild(h);let m=n.over=Ai(nb,d);i=lo(i);let y=+Dt(i.pxAlign,1),p=Bg(y);(i.plugins||[]).forEach(b=>{b.opts&&(i=b.opts(n,i)||i)});let g=i.ms||.001,v=n.series=s==1?Gg(i.series||[],Lg,Og,!1):OM(i.series||[null],Ug),M=n.axes=Gg(i.axes||[],Ig,Dg,!0),_=n.scales={},E=n.bands=i.bands||[];E.forEach(b=>{b.fill=Ct(b.fill||null),b.dir=Dt(b.dir,-1)});let T=s==2?v[1].facets[0].scale:v[0].scale,x={axes:Ms,series:wt},S=(i.drawOrder||["axes","series"]).map(b=>x[b]);function O(b){let A=b.distr==3?N=>Es(N>0?N:b.clamp(n,N,b.min,b.max,b.key)):b.distr==4?N=>md(N,b.asinh):b.distr==100?N=>b.fwd(N):N=>N;return N=>{let D=A(N),{_min:X,_max:j}=b,ue=j-X;return(D-X)/ue}}function L(b){let A=_[b];if(A==null){let N=(i.scales||Ea)[b]||Ea;if(N.from!=null){L(N.from);let D=_n({},_[N.from],N,{key:b});D.valToPct=O(D),_[b]=D}else{A=_[b]=_n({},b==T?y0:EM,N),A.key=b;let D=A.time,X=A.range,j=Qs(X);if((b!=T||s==2&&!D)&&(j&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?yg:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?yg:{mode:1,hard:X[1],soft:X[1]}},j=!1),!j&&Zl(X))){let ue=X;X=(me,Te,Ve)=>Te==null?ao:ql(Te,Ve,ue)}A.range=Ct(X||(D?kM:b==T?A.distr==3?zM:A.distr==4?VM:A0:A.distr==3?C0:A.distr==4?R0:BM)),A.auto=Ct(j?!1:A.auto),A.clamp=Ct(A.clamp||wM),A._min=A._max=null,A.valToPct=O(A)}}}L("x"),L("y"),s==1&&v.forEach(b=>{L(b.scale)}),M.forEach(b=>{L(b.scale)});for(let b in i.scales)L(b);let R=_[T],U=R.distr,z,I;R.ori==0?(ui(c,Z_),z=r,I=o):(ui(c,j_),z=o,I=r);let G={};for(let b in _){let A=_[b];(A.min!=null||A.max!=null)&&(G[b]={min:A.min,max:A.max},A.min=A.max=null)}let q=i.tzDate||(b=>new Date(En(b/g))),H=i.fmtDate||Ud,he=g==1?Zb(q):eM(q),Y=Cg(q,Ag(g==1?Kb:Qb,H)),ee=Pg(q,Rg(nM,H)),J=[],ae=n.legend=_n({},rM,i.legend),re=n.cursor=_n({},uM,{drag:{y:s==2}},i.cursor),Q=ae.show,pe=re.show,ye=ae.markers;ae.idxs=J,ye.width=Ct(ye.width),ye.dash=Ct(ye.dash),ye.stroke=Ct(ye.stroke),ye.fill=Ct(ye.fill);let Ae,Se,He,ot=[],Ze=[],at,rt=!1,le={};if(ae.live){let b=v[1]?v[1].values:null;rt=b!=null,at=rt?b(n,1,0):{_:0};for(let A in at)le[A]=Pd}if(Q)if(Ae=Ui("table",lb,c),He=Ui("tbody",null,Ae),ae.mount(n,Ae),rt){Se=Ui("thead",null,Ae,He);let b=Ui("tr",null,Se);Ui("th",null,b);for(var xe in at)Ui("th",sg,b).textContent=xe}else ui(Ae,hb),ae.live&&ui(Ae,cb);let ve={show:!0},Be={show:!1};function Le(b,A){if(A==0&&(rt||!ae.live||s==2))return ao;let N=[],D=Ui("tr",ub,He,He.childNodes[A]);ui(D,b.class),b.show||ui(D,Sr);let X=Ui("th",null,D);if(ye.show){let me=Ai(db,X);if(A>0){let Te=ye.width(n,A);Te&&(me.style.border=Te+"px "+ye.dash(n,A)+" "+ye.stroke(n,A)),me.style.background=ye.fill(n,A)}}let j=Ai(sg,X);b.label instanceof HTMLElement?j.appendChild(b.label):j.textContent=b.label,A>0&&(ye.show||(j.style.color=b.width>0?ye.stroke(n,A):ye.fill(n,A)),ze("click",X,me=>{if(re._lock)return;ct(me);let Te=v.indexOf(b);if((me.ctrlKey||me.metaKey)!=ae.isolate){let Ve=v.some((Ge,Xe)=>Xe>0&&Xe!=Te&&Ge.show);v.forEach((Ge,Xe)=>{Xe>0&&Ki(Xe,Ve?Xe==Te?ve:Be:ve,!0,vn.setSeries)})}else Ki(Te,{show:!b.show},!0,vn.setSeries)},!1),ht&&ze(lg,X,me=>{re._lock||(ct(me),Ki(v.indexOf(b),jr,!0,vn.setSeries))},!1));for(var ue in at){let me=Ui("td",fb,D);me.textContent="--",N.push(me)}return[D,N]}let st=new Map;function ze(b,A,N,D=!0){let X=st.get(A)||{},j=re.bind[b](n,A,N,D);j&&(wr(b,A,X[b]=j),st.set(A,X))}function yt(b,A,N){let D=st.get(A)||{};for(let X in D)(b==null||X==b)&&(Md(X,A,D[X]),delete D[X]);b==null&&st.delete(A)}let pt=0,xt=0,B=0,be=0,qe=0,dt=0,we=qe,Ot=dt,Je=B,nt=be,P=0,w=0,$=0,fe=0;n.bbox={};let ce=!1,Me=!1,Ee=!1,ne=!1,se=!1,ge=!1;function V(b,A,N){(N||b!=n.width||A!=n.height)&&oe(b,A),_t(!1),Ee=!0,Me=!0,zn()}function oe(b,A){n.width=pt=B=b,n.height=xt=be=A,qe=dt=0,Ce(),Qe();let N=n.bbox;P=N.left=br(qe*Ut,.5),w=N.top=br(dt*Ut,.5),$=N.width=br(B*Ut,.5),fe=N.height=br(be*Ut,.5)}let ie=3;function Re(){let b=!1,A=0;for(;!b;){A++;let N=qr(A),D=Ji(A);b=A==ie||N&&D,b||(oe(n.width,n.height),Me=!0)}}function _e({width:b,height:A}){V(b,A)}n.setSize=_e;function Ce(){let b=!1,A=!1,N=!1,D=!1;M.forEach((X,j)=>{if(X.show&&X._show){let{side:ue,_size:me}=X,Te=ue%2,Ve=X.label!=null?X.labelSize:0,Ge=me+Ve;Ge>0&&(Te?(B-=Ge,ue==3?(qe+=Ge,D=!0):N=!0):(be-=Ge,ue==0?(dt+=Ge,b=!0):A=!0))}}),$i[0]=b,$i[1]=N,$i[2]=A,$i[3]=D,B-=Li[1]+Li[3],qe+=Li[3],be-=Li[2]+Li[0],dt+=Li[0]}function Qe(){let b=qe+B,A=dt+be,N=qe,D=dt;function X(j,ue){switch(j){case 1:return b+=ue,b-ue;case 2:return A+=ue,A-ue;case 3:return N-=ue,N+ue;case 0:return D-=ue,D+ue}}M.forEach((j,ue)=>{if(j.show&&j._show){let me=j.side;j._pos=X(me,j._size),j.label!=null&&(j._lpos=X(me,j.labelSize))}})}if(re.dataIdx==null){let b=re.hover,A=b.skip=new Set(b.skip??[]);A.add(void 0);let N=b.prox=Ct(b.prox),D=b.bias??=0;re.dataIdx=(X,j,ue,me)=>{if(j==0)return ue;let Te=ue,Ve=N(X,j,ue,me)??Xt,Ge=Ve>=0&&Ve<Xt,Xe=R.ori==0?B:be,gt=re.left,Ft=e[0],It=e[j];if(A.has(It[ue])){Te=null;let Et=null,lt=null,et;if(D==0||D==-1)for(et=ue;Et==null&&et-- >0;)A.has(It[et])||(Et=et);if(D==0||D==1)for(et=ue;lt==null&&et++<It.length;)A.has(It[et])||(lt=et);if(Et!=null||lt!=null)if(Ge){let Zt=Et==null?-1/0:z(Ft[Et],R,Xe,0),cn=lt==null?1/0:z(Ft[lt],R,Xe,0),Nn=gt-Zt,Wt=cn-gt;Nn<=Wt?Nn<=Ve&&(Te=Et):Wt<=Ve&&(Te=lt)}else Te=lt==null?Et:Et==null?lt:ue-Et<=lt-ue?Et:lt}else Ge&&Tn(gt-z(Ft[ue],R,Xe,0))>Ve&&(Te=null);return Te}}let ct=b=>{re.event=b};re.idxs=J,re._lock=!1;let de=re.points;de.show=Ct(de.show),de.size=Ct(de.size),de.stroke=Ct(de.stroke),de.width=Ct(de.width),de.fill=Ct(de.fill);let $e=n.focus=_n({},i.focus||{alpha:.3},re.focus),ht=$e.prox>=0,Ne=ht&&de.one,vt=[],Yt=[],qn=[];function ca(b,A){let N=de.show(n,A);if(N instanceof HTMLElement)return ui(N,ab),ui(N,b.class),ls(N,-10,-10,B,be),m.insertBefore(N,vt[A]),N}function Hr(b,A){if(s==1||A>0){let N=s==1&&_[b.scale].time,D=b.value;b.value=N?Sg(D)?Pg(q,Rg(D,H)):D||ee:D||bM,b.label=b.label||(N?fM:dM)}if(Ne||A>0){b.width=b.width==null?1:b.width,b.paths=b.paths||FM||Eb,b.fillTo=Ct(b.fillTo||TM),b.pxAlign=+Dt(b.pxAlign,y),b.pxRound=Bg(b.pxAlign),b.stroke=Ct(b.stroke||null),b.fill=Ct(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let N=MM(jn(1,b.width),1),D=b.points=_n({},{size:N,width:jn(1,N*.2),stroke:b.stroke,space:N*2,paths:UM,_stroke:null,_fill:null},b.points);D.show=Ct(D.show),D.filter=Ct(D.filter),D.fill=Ct(D.fill),D.stroke=Ct(D.stroke),D.paths=Ct(D.paths),D.pxAlign=b.pxAlign}if(Q){let N=Le(b,A);ot.splice(A,0,N[0]),Ze.splice(A,0,N[1]),ae.values.push(null)}if(pe){J.splice(A,0,null);let N=null;Ne?A==0&&(N=ca(b,A)):A>0&&(N=ca(b,A)),vt.splice(A,0,N),Yt.splice(A,0,0),qn.splice(A,0,0)}Ln("addSeries",A)}function zu(b,A){A=A??v.length,b=s==1?Cd(b,A,Lg,Og):Cd(b,A,{},Ug),v.splice(A,0,b),Hr(v[A],A)}n.addSeries=zu;function wl(b){if(v.splice(b,1),Q){ae.values.splice(b,1),Ze.splice(b,1);let A=ot.splice(b,1)[0];yt(null,A.firstChild),A.remove()}pe&&(J.splice(b,1),vt.splice(b,1)[0].remove(),Yt.splice(b,1),qn.splice(b,1)),Ln("delSeries",b)}n.delSeries=wl;let $i=[!1,!1,!1,!1];function xs(b,A){if(b._show=b.show,b.show){let N=b.side%2,D=_[b.scale];D==null&&(b.scale=N?v[1].scale:T,D=_[b.scale]);let X=D.time;b.size=Ct(b.size),b.space=Ct(b.space),b.rotate=Ct(b.rotate),Qs(b.incrs)&&b.incrs.forEach(ue=>{!er.has(ue)&&er.set(ue,jg(ue))}),b.incrs=Ct(b.incrs||(D.distr==2?$b:X?g==1?Jb:jb:Mr)),b.splits=Ct(b.splits||(X&&D.distr==1?he:D.distr==3?wd:D.distr==4?gM:mM)),b.stroke=Ct(b.stroke),b.grid.stroke=Ct(b.grid.stroke),b.ticks.stroke=Ct(b.ticks.stroke),b.border.stroke=Ct(b.border.stroke);let j=b.values;b.values=Qs(j)&&!Qs(j[0])?Ct(j):X?Qs(j)?Cg(q,Ag(j,H)):Sg(j)?tM(q,j):j||Y:j||pM,b.filter=Ct(b.filter||(D.distr>=3&&D.log==10?xM:D.distr==3&&D.log==2?_M:Kg)),b.font=Hg(b.font),b.labelFont=Hg(b.labelFont),b._size=b.size(n,null,A,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&($i[A]=!0,b._el=Ai(ib,d))}}function _s(b,A,N,D){let[X,j,ue,me]=N,Te=A%2,Ve=0;return Te==0&&(me||j)&&(Ve=A==0&&!X||A==2&&!ue?En(Ig.size/3):0),Te==1&&(X||ue)&&(Ve=A==1&&!j||A==3&&!me?En(Dg.size/2):0),Ve}let ha=n.padding=(i.padding||[_s,_s,_s,_s]).map(b=>Ct(Dt(b,_s))),Li=n._padding=ha.map((b,A)=>b(n,A,$i,0)),an,un=null,dn=null,Yi=s==1?v[0].idxs:null,oi=null,Ws=!1;function ua(b,A){if(e=b??[],n.data=n._data=e,s==2){an=0;for(let N=1;N<v.length;N++)an+=e[N][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),oi=e[0],an=oi.length;let N=e;if(U==2){N=e.slice();let D=N[0]=Array(an);for(let X=0;X<an;X++)D[X]=X}n._data=e=N}if(_t(!0),Ln("setData"),U==2&&(Ee=!0),A!==!1){let N=R;N.auto(n,Ws)?da():$s(T,N.min,N.max),ne=ne||re.left>=0,ge=!0,zn()}}n.setData=ua;function da(){Ws=!0;let b,A;s==1&&(an>0?(un=Yi[0]=0,dn=Yi[1]=an-1,b=e[0][un],A=e[0][dn],U==2?(b=un,A=dn):b==A&&(U==3?[b,A]=Jl(b,b,R.log,!1):U==4?[b,A]=Ld(b,b,R.log,!1):R.time?A=b+En(86400/g):[b,A]=ql(b,A,Nd,!0))):(un=Yi[0]=b=null,dn=Yi[1]=A=null)),$s(T,b,A)}let Wr,Xs,Xr,C,W,te,K,Z,Pe,De;function Ie(b,A,N,D,X,j){b??=og,N??=Fd,D??="butt",X??=og,j??="round",b!=Wr&&(u.strokeStyle=Wr=b),X!=Xs&&(u.fillStyle=Xs=X),A!=Xr&&(u.lineWidth=Xr=A),j!=W&&(u.lineJoin=W=j),D!=te&&(u.lineCap=te=D),N!=C&&u.setLineDash(C=N)}function Ue(b,A,N,D){A!=Xs&&(u.fillStyle=Xs=A),b!=K&&(u.font=K=b),N!=Z&&(u.textAlign=Z=N),D!=Pe&&(u.textBaseline=Pe=D)}function Ke(b,A,N,D,X=0){if(D.length>0&&b.auto(n,Ws)&&(A==null||A.min==null)){let j=Dt(un,0),ue=Dt(dn,D.length-1),me=N.min==null?xb(D,j,ue,X,b.distr==3):[N.min,N.max];b.min=ki(b.min,N.min=me[0]),b.max=jn(b.max,N.max=me[1])}}let ft={min:null,max:null};function St(){for(let D in _){let X=_[D];G[D]==null&&(X.min==null||G[T]!=null&&X.auto(n,Ws))&&(G[D]=ft)}for(let D in _){let X=_[D];G[D]==null&&X.from!=null&&G[X.from]!=null&&(G[D]=ft)}G[T]!=null&&_t(!0);let b={};for(let D in G){let X=G[D];if(X!=null){let j=b[D]=lo(_[D],Cb);if(X.min!=null)_n(j,X);else if(D!=T||s==2)if(an==0&&j.from==null){let ue=j.range(n,null,null,D);j.min=ue[0],j.max=ue[1]}else j.min=Xt,j.max=-Xt}}if(an>0){v.forEach((D,X)=>{if(s==1){let j=D.scale,ue=G[j];if(ue==null)return;let me=b[j];if(X==0){let Te=me.range(n,me.min,me.max,j);me.min=Te[0],me.max=Te[1],un=Oi(me.min,e[0]),dn=Oi(me.max,e[0]),dn-un>1&&(e[0][un]<me.min&&un++,e[0][dn]>me.max&&dn--),D.min=oi[un],D.max=oi[dn]}else D.show&&D.auto&&Ke(me,ue,D,e[X],D.sorted);D.idxs[0]=un,D.idxs[1]=dn}else if(X>0&&D.show&&D.auto){let[j,ue]=D.facets,me=j.scale,Te=ue.scale,[Ve,Ge]=e[X],Xe=b[me],gt=b[Te];Xe!=null&&Ke(Xe,G[me],j,Ve,j.sorted),gt!=null&&Ke(gt,G[Te],ue,Ge,ue.sorted),D.min=ue.min,D.max=ue.max}});for(let D in b){let X=b[D],j=G[D];if(X.from==null&&(j==null||j.min==null)){let ue=X.range(n,X.min==Xt?null:X.min,X.max==-Xt?null:X.max,D);X.min=ue[0],X.max=ue[1]}}}for(let D in b){let X=b[D];if(X.from!=null){let j=b[X.from];if(j.min==null)X.min=X.max=null;else{let ue=X.range(n,j.min,j.max,D);X.min=ue[0],X.max=ue[1]}}}let A={},N=!1;for(let D in b){let X=b[D],j=_[D];if(j.min!=X.min||j.max!=X.max){j.min=X.min,j.max=X.max;let ue=j.distr;j._min=ue==3?Es(j.min):ue==4?md(j.min,j.asinh):ue==100?j.fwd(j.min):j.min,j._max=ue==3?Es(j.max):ue==4?md(j.max,j.asinh):ue==100?j.fwd(j.max):j.max,A[D]=N=!0}}if(N){v.forEach((D,X)=>{s==2?X>0&&A.y&&(D._paths=null):A[D.scale]&&(D._paths=null)});for(let D in A)Ee=!0,Ln("setScale",D);pe&&re.left>=0&&(ne=ge=!0)}for(let D in G)G[D]=null}function Ye(b){let A=Sd(un-1,0,an-1),N=Sd(dn+1,0,an-1);for(;b[A]==null&&A>0;)A--;for(;b[N]==null&&N<an-1;)N++;return[A,N]}function wt(){if(an>0){let b=v.some(A=>A._focus)&&De!=$e.alpha;b&&(u.globalAlpha=De=$e.alpha),v.forEach((A,N)=>{if(N>0&&A.show&&(sn(N,!1),sn(N,!0),A._paths==null)){let D=De;De!=A.alpha&&(u.globalAlpha=De=A.alpha);let X=s==2?[0,e[N][0].length-1]:Ye(e[N]);A._paths=A.paths(n,N,X[0],X[1]),De!=D&&(u.globalAlpha=De=D)}}),v.forEach((A,N)=>{if(N>0&&A.show){let D=De;De!=A.alpha&&(u.globalAlpha=De=A.alpha),A._paths!=null&&zt(N,!1);{let X=A._paths!=null?A._paths.gaps:null,j=A.points.show(n,N,un,dn,X),ue=A.points.filter(n,N,j,X);(j||ue)&&(A.points._paths=A.points.paths(n,N,un,dn,ue),zt(N,!0))}De!=D&&(u.globalAlpha=De=D),Ln("drawSeries",N)}}),b&&(u.globalAlpha=De=1)}}function sn(b,A){let N=A?v[b].points:v[b];N._stroke=N.stroke(n,b),N._fill=N.fill(n,b)}function zt(b,A){let N=A?v[b].points:v[b],{stroke:D,fill:X,clip:j,flags:ue,_stroke:me=N._stroke,_fill:Te=N._fill,_width:Ve=N.width}=N._paths;Ve=qt(Ve*Ut,3);let Ge=null,Xe=Ve%2/2;A&&Te==null&&(Te=Ve>0?"#fff":me);let gt=N.pxAlign==1&&Xe>0;if(gt&&u.translate(Xe,Xe),!A){let Ft=P-Ve/2,It=w-Ve/2,Et=$+Ve,lt=fe+Ve;Ge=new Path2D,Ge.rect(Ft,It,Et,lt)}A?We(me,Ve,N.dash,N.cap,Te,D,X,ue,j):Vt(b,me,Ve,N.dash,N.cap,Te,D,X,ue,Ge,j),gt&&u.translate(-Xe,-Xe)}function Vt(b,A,N,D,X,j,ue,me,Te,Ve,Ge){let Xe=!1;Te!=0&&E.forEach((gt,Ft)=>{if(gt.series[0]==b){let It=v[gt.series[1]],Et=e[gt.series[1]],lt=(It._paths||Ea).band;Qs(lt)&&(lt=gt.dir==1?lt[0]:lt[1]);let et,Zt=null;It.show&&lt&&bb(Et,un,dn)?(Zt=gt.fill(n,Ft)||j,et=It._paths.clip):lt=null,We(A,N,D,X,Zt,ue,me,Te,Ve,Ge,et,lt),Xe=!0}}),Xe||We(A,N,D,X,j,ue,me,Te,Ve,Ge)}let Sn=co|Td;function We(b,A,N,D,X,j,ue,me,Te,Ve,Ge,Xe){Ie(b,A,N,D,X),(Te||Ve||Xe)&&(u.save(),Te&&u.clip(Te),Ve&&u.clip(Ve)),Xe?(me&Sn)==Sn?(u.clip(Xe),Ge&&u.clip(Ge),At(X,ue),mn(b,j,A)):me&Td?(At(X,ue),u.clip(Xe),mn(b,j,A)):me&co&&(u.save(),u.clip(Xe),Ge&&u.clip(Ge),At(X,ue),u.restore(),mn(b,j,A)):(At(X,ue),mn(b,j,A)),(Te||Ve||Xe)&&u.restore()}function mn(b,A,N){N>0&&(A instanceof Map?A.forEach((D,X)=>{u.strokeStyle=Wr=X,u.stroke(D)}):A!=null&&b&&u.stroke(A))}function At(b,A){A instanceof Map?A.forEach((N,D)=>{u.fillStyle=Xs=D,u.fill(N)}):A!=null&&b&&u.fill(A)}function bs(b,A,N,D){let X=M[b],j;if(D<=0)j=[0,0];else{let ue=X._space=X.space(n,b,A,N,D),me=X._incrs=X.incrs(n,b,A,N,D,ue);j=GM(A,N,me,D,ue)}return X._found=j}function gn(b,A,N,D,X,j,ue,me,Te,Ve){let Ge=ue%2/2;y==1&&u.translate(Ge,Ge),Ie(me,ue,Te,Ve,me),u.beginPath();let Xe,gt,Ft,It,Et=X+(D==0||D==3?-j:j);N==0?(gt=X,It=Et):(Xe=X,Ft=Et);for(let lt=0;lt<b.length;lt++)A[lt]!=null&&(N==0?Xe=Ft=b[lt]:gt=It=b[lt],u.moveTo(Xe,gt),u.lineTo(Ft,It));u.stroke(),y==1&&u.translate(-Ge,-Ge)}function qr(b){let A=!0;return M.forEach((N,D)=>{if(!N.show)return;let X=_[N.scale];if(X.min==null){N._show&&(A=!1,N._show=!1,_t(!1));return}else N._show||(A=!1,N._show=!0,_t(!1));let j=N.side,ue=j%2,{min:me,max:Te}=X,[Ve,Ge]=bs(D,me,Te,ue==0?B:be);if(Ge==0)return;let Xe=X.distr==2,gt=N._splits=N.splits(n,D,me,Te,Ve,Ge,Xe),Ft=X.distr==2?gt.map(et=>oi[et]):gt,It=X.distr==2?oi[gt[1]]-oi[gt[0]]:Ve,Et=N._values=N.values(n,N.filter(n,Ft,D,Ge,It),D,Ge,It);N._rotate=j==2?N.rotate(n,Et,D,Ge):0;let lt=N._size;N._size=Ci(N.size(n,Et,D,b)),lt!=null&&N._size!=lt&&(A=!1)}),A}function Ji(b){let A=!0;return ha.forEach((N,D)=>{let X=N(n,D,$i,b);X!=Li[D]&&(A=!1),Li[D]=X}),A}function Ms(){for(let b=0;b<M.length;b++){let A=M[b];if(!A.show||!A._show)continue;let N=A.side,D=N%2,X,j,ue=A.stroke(n,b),me=N==0||N==3?-1:1,[Te,Ve]=A._found;if(A.label!=null){let Jn=A.labelGap*me,ci=En((A._lpos+Jn)*Ut);Ue(A.labelFont[0],ue,"center",N==2?"top":rg),u.save(),D==1?(X=j=0,u.translate(ci,En(w+fe/2)),u.rotate((N==3?-Wl:Wl)/2)):(X=En(P+$/2),j=ci);let yr=Yg(A.label)?A.label(n,b,Te,Ve):A.label;u.fillText(yr,X,j),u.restore()}if(Ve==0)continue;let Ge=_[A.scale],Xe=D==0?$:fe,gt=D==0?P:w,Ft=A._splits,It=Ge.distr==2?Ft.map(Jn=>oi[Jn]):Ft,Et=Ge.distr==2?oi[Ft[1]]-oi[Ft[0]]:Te,lt=A.ticks,et=A.border,Zt=lt.show?lt.size:0,cn=En(Zt*Ut),Nn=En((A.alignTo==2?A._size-Zt-A.gap:A.gap)*Ut),Wt=A._rotate*-Wl/180,hn=p(A._pos*Ut),ai=(cn+Nn)*me,Yn=hn+ai;j=D==0?Yn:0,X=D==1?Yn:0;let Mi=A.font[0],Ni=A.align==1?io:A.align==2?dd:Wt>0?io:Wt<0?dd:D==0?"center":N==3?dd:io,ji=Wt||D==1?"middle":N==2?"top":rg;Ue(Mi,ue,Ni,ji);let li=A.font[1]*A.lineGap,Si=Ft.map(Jn=>p(a(Jn,Ge,Xe,gt))),Di=A._values;for(let Jn=0;Jn<Di.length;Jn++){let ci=Di[Jn];if(ci!=null){D==0?X=Si[Jn]:j=Si[Jn],ci=""+ci;let yr=ci.indexOf(`
`)==-1?[ci]:ci.split(/\n/gm);for(let Kn=0;Kn<yr.length;Kn++){let cm=yr[Kn];Wt?(u.save(),u.translate(X,j+Kn*li),u.rotate(Wt),u.fillText(cm,0,0),u.restore()):u.fillText(cm,X,j+Kn*li)}}}lt.show&&gn(Si,lt.filter(n,It,b,Ve,Et),D,N,hn,cn,qt(lt.width*Ut,3),lt.stroke(n,b),lt.dash,lt.cap);let Qi=A.grid;Qi.show&&gn(Si,Qi.filter(n,It,b,Ve,Et),D,D==0?2:1,D==0?w:P,D==0?fe:$,qt(Qi.width*Ut,3),Qi.stroke(n,b),Qi.dash,Qi.cap),et.show&&gn([hn],[1],D==0?1:0,D==0?1:2,D==1?w:P,D==1?fe:$,qt(et.width*Ut,3),et.stroke(n,b),et.dash,et.cap)}Ln("drawAxes")}function _t(b){v.forEach((A,N)=>{N>0&&(A._paths=null,b&&(s==1?(A.min=null,A.max=null):A.facets.forEach(D=>{D.min=null,D.max=null})))})}let ln=!1,$n=!1,Gt=[];function yn(){$n=!1;for(let b=0;b<Gt.length;b++)Ln(...Gt[b]);Gt.length=0}function zn(){ln||(Fb(Xp),ln=!0)}function El(b,A=!1){ln=!0,$n=A,b(n),Xp(),A&&Gt.length>0&&queueMicrotask(yn)}n.batch=El;function Xp(){if(ce&&(St(),ce=!1),Ee&&(Re(),Ee=!1),Me){if(jt(f,io,qe),jt(f,"top",dt),jt(f,ba,B),jt(f,Ma,be),jt(m,io,qe),jt(m,"top",dt),jt(m,ba,B),jt(m,Ma,be),jt(d,ba,pt),jt(d,Ma,xt),h.width=En(pt*Ut),h.height=En(xt*Ut),M.forEach(({_el:b,_show:A,_size:N,_pos:D,side:X})=>{if(b!=null)if(A){let j=X===3||X===0?N:0,ue=X%2==1;jt(b,ue?"left":"top",D-j),jt(b,ue?"width":"height",N),jt(b,ue?"top":"left",ue?dt:qe),jt(b,ue?"height":"width",ue?be:B),bd(b,Sr)}else ui(b,Sr)}),Wr=Xs=Xr=W=te=K=Z=Pe=C=null,De=1,ma(!0),qe!=we||dt!=Ot||B!=Je||be!=nt){_t(!1);let b=B/Je,A=be/nt;if(pe&&!ne&&re.left>=0){re.left*=b,re.top*=A,$r&&ls($r,En(re.left),0,B,be),Yr&&ls(Yr,0,En(re.top),B,be);for(let N=0;N<vt.length;N++){let D=vt[N];D!=null&&(Yt[N]*=b,qn[N]*=A,ls(D,Ci(Yt[N]),Ci(qn[N]),B,be))}}if(Kt.show&&!se&&Kt.left>=0&&Kt.width>0){Kt.left*=b,Kt.width*=b,Kt.top*=A,Kt.height*=A;for(let N in qu)jt(Zr,N,Kt[N])}we=qe,Ot=dt,Je=B,nt=be}Ln("setSize"),Me=!1}pt>0&&xt>0&&(u.clearRect(0,0,h.width,h.height),Ln("drawClear"),S.forEach(b=>b()),Ln("draw")),Kt.show&&se&&(Tl(Kt),se=!1),pe&&ne&&(gr(null,!0,!1),ne=!1),ae.show&&ae.live&&ge&&(Wu(),ge=!1),l||(l=!0,n.status=1,Ln("ready")),Ws=!1,ln=!1}n.redraw=(b,A)=>{Ee=A||!1,b!==!1?$s(T,R.min,R.max):zn()};function Vu(b,A){let N=_[b];if(N.from==null){if(an==0){let D=N.range(n,A.min,A.max,b);A.min=D[0],A.max=D[1]}if(A.min>A.max){let D=A.min;A.min=A.max,A.max=D}if(an>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;b==T&&N.distr==2&&an>0&&(A.min=Oi(A.min,e[0]),A.max=Oi(A.max,e[0]),A.min==A.max&&A.max++),G[b]=A,ce=!0,zn()}}n.setScale=Vu;let Gu,Hu,$r,Yr,qp,$p,Jr,Kr,Yp,Jp,Jt,tn,qs=!1,Un=re.drag,Pn=Un.x,In=Un.y;pe&&(re.x&&(Gu=Ai(rb,m)),re.y&&(Hu=Ai(ob,m)),R.ori==0?($r=Gu,Yr=Hu):($r=Hu,Yr=Gu),Jt=re.left,tn=re.top);let Kt=n.select=_n({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Zr=Kt.show?Ai(sb,Kt.over?m:f):null;function Tl(b,A){if(Kt.show){for(let N in b)Kt[N]=b[N],N in qu&&jt(Zr,N,b[N]);A!==!1&&Ln("setSelect")}}n.setSelect=Tl;function Gx(b){if(v[b].show)Q&&bd(ot[b],Sr);else if(Q&&ui(ot[b],Sr),pe){let N=Ne?vt[0]:vt[b];N!=null&&ls(N,-10,-10,B,be)}}function $s(b,A,N){Vu(b,{min:A,max:N})}function Ki(b,A,N,D){A.focus!=null&&$x(b),A.show!=null&&v.forEach((X,j)=>{j>0&&(b==j||b==null)&&(X.show=A.show,Gx(j),s==2?($s(X.facets[0].scale,null,null),$s(X.facets[1].scale,null,null)):$s(X.scale,null,null),zn())}),N!==!1&&Ln("setSeries",b,A),D&&ga("setSeries",n,b,A)}n.setSeries=Ki;function Hx(b,A){_n(E[b],A)}function Wx(b,A){b.fill=Ct(b.fill||null),b.dir=Dt(b.dir,-1),A=A??E.length,E.splice(A,0,b)}function Xx(b){b==null?E.length=0:E.splice(b,1)}n.addBand=Wx,n.setBand=Hx,n.delBand=Xx;function qx(b,A){v[b].alpha=A,pe&&vt[b]!=null&&(vt[b].style.opacity=A),Q&&ot[b]&&(ot[b].style.opacity=A)}let Ss,Ys,mr,jr={focus:!0};function $x(b){if(b!=mr){let A=b==null,N=$e.alpha!=1;v.forEach((D,X)=>{if(s==1||X>0){let j=A||X==0||X==b;D._focus=A?null:j,N&&qx(X,j?1:$e.alpha)}}),mr=b,N&&zn()}}Q&&ht&&ze(cg,Ae,b=>{re._lock||(ct(b),mr!=null&&Ki(null,jr,!0,vn.setSeries))});function Zi(b,A,N){let D=_[A];N&&(b=b/Ut-(D.ori==1?dt:qe));let X=B;D.ori==1&&(X=be,b=X-b),D.dir==-1&&(b=X-b);let j=D._min,ue=D._max,me=b/X,Te=j+(ue-j)*me,Ve=D.distr;return Ve==3?oo(10,Te):Ve==4?Sb(Te,D.asinh):Ve==100?D.bwd(Te):Te}function Yx(b,A){let N=Zi(b,T,A);return Oi(N,e[0],un,dn)}n.valToIdx=b=>Oi(b,e[0]),n.posToIdx=Yx,n.posToVal=Zi,n.valToPos=(b,A,N)=>_[A].ori==0?r(b,_[A],N?$:B,N?P:0):o(b,_[A],N?fe:be,N?w:0),n.setCursor=(b,A,N)=>{Jt=b.left,tn=b.top,gr(null,A,N)};function Kp(b,A){jt(Zr,io,Kt.left=b),jt(Zr,ba,Kt.width=A)}function Zp(b,A){jt(Zr,"top",Kt.top=b),jt(Zr,Ma,Kt.height=A)}let fa=R.ori==0?Kp:Zp,pa=R.ori==1?Kp:Zp;function Jx(){if(Q&&ae.live)for(let b=s==2?1:0;b<v.length;b++){if(b==0&&rt)continue;let A=ae.values[b],N=0;for(let D in A)Ze[b][N++].firstChild.nodeValue=A[D]}}function Wu(b,A){if(b!=null&&(b.idxs?b.idxs.forEach((N,D)=>{J[D]=N}):Ab(b.idx)||J.fill(b.idx),ae.idx=J[0]),Q&&ae.live){for(let N=0;N<v.length;N++)(N>0||s==1&&!rt)&&Kx(N,J[N]);Jx()}ge=!1,A!==!1&&Ln("setLegend")}n.setLegend=Wu;function Kx(b,A){let N=v[b],D=b==0&&U==2?oi:e[b],X;rt?X=N.values(n,b,A)??le:(X=N.value(n,A==null?null:D[A],b,A),X=X==null?le:{_:X}),ae.values[b]=X}function gr(b,A,N){Yp=Jt,Jp=tn,[Jt,tn]=re.move(n,Jt,tn),re.left=Jt,re.top=tn,pe&&($r&&ls($r,En(Jt),0,B,be),Yr&&ls(Yr,0,En(tn),B,be));let D,X=un>dn;Ss=Xt,Ys=null;let j=R.ori==0?B:be,ue=R.ori==1?B:be;if(Jt<0||an==0||X){D=re.idx=null;for(let me=0;me<v.length;me++){let Te=vt[me];Te!=null&&ls(Te,-10,-10,B,be)}ht&&Ki(null,jr,!0,b==null&&vn.setSeries),ae.live&&(J.fill(D),ge=!0)}else{let me,Te,Ve;s==1&&(me=R.ori==0?Jt:tn,Te=Zi(me,T),D=re.idx=Oi(Te,e[0],un,dn),Ve=z(e[0][D],R,j,0));let Ge=-10,Xe=-10,gt=0,Ft=0,It=!0,Et="",lt="";for(let et=s==2?1:0;et<v.length;et++){let Zt=v[et],cn=J[et],Nn=cn==null?null:s==1?e[et][cn]:e[et][1][cn],Wt=re.dataIdx(n,et,D,Te),hn=Wt==null?null:s==1?e[et][Wt]:e[et][1][Wt];if(ge=ge||hn!=Nn||Wt!=cn,J[et]=Wt,et>0&&Zt.show){let ai=Wt==null?-10:Wt==D?Ve:z(s==1?e[0][Wt]:e[et][0][Wt],R,j,0),Yn=hn==null?-10:I(hn,s==1?_[Zt.scale]:_[Zt.facets[1].scale],ue,0);if(ht&&hn!=null){let Mi=R.ori==1?Jt:tn,Ni=Tn($e.dist(n,et,Wt,Yn,Mi));if(Ni<Ss){let ji=$e.bias;if(ji!=0){let li=Zi(Mi,Zt.scale),Si=hn>=0?1:-1,Di=li>=0?1:-1;Di==Si&&(Di==1?ji==1?hn>=li:hn<=li:ji==1?hn<=li:hn>=li)&&(Ss=Ni,Ys=et)}else Ss=Ni,Ys=et}}if(ge||Ne){let Mi,Ni;R.ori==0?(Mi=ai,Ni=Yn):(Mi=Yn,Ni=ai);let ji,li,Si,Di,Qi,Jn,ci=!0,yr=de.bbox;if(yr!=null){ci=!1;let Kn=yr(n,et);Si=Kn.left,Di=Kn.top,ji=Kn.width,li=Kn.height}else Si=Mi,Di=Ni,ji=li=de.size(n,et);if(Jn=de.fill(n,et),Qi=de.stroke(n,et),Ne)et==Ys&&Ss<=$e.prox&&(Ge=Si,Xe=Di,gt=ji,Ft=li,It=ci,Et=Jn,lt=Qi);else{let Kn=vt[et];Kn!=null&&(Yt[et]=Si,qn[et]=Di,gg(Kn,ji,li,ci),pg(Kn,Jn,Qi),ls(Kn,Ci(Si),Ci(Di),B,be))}}}}if(Ne){let et=$e.prox,Zt=mr==null?Ss<=et:Ss>et||Ys!=mr;if(ge||Zt){let cn=vt[0];cn!=null&&(Yt[0]=Ge,qn[0]=Xe,gg(cn,gt,Ft,It),pg(cn,Et,lt),ls(cn,Ci(Ge),Ci(Xe),B,be))}}}if(Kt.show&&qs)if(b!=null){let[me,Te]=vn.scales,[Ve,Ge]=vn.match,[Xe,gt]=b.cursor.sync.scales,Ft=b.cursor.drag;if(Pn=Ft._x,In=Ft._y,Pn||In){let{left:It,top:Et,width:lt,height:et}=b.select,Zt=b.scales[Xe].ori,cn=b.posToVal,Nn,Wt,hn,ai,Yn,Mi=me!=null&&Ve(me,Xe),Ni=Te!=null&&Ge(Te,gt);Mi&&Pn?(Zt==0?(Nn=It,Wt=lt):(Nn=Et,Wt=et),hn=_[me],ai=z(cn(Nn,Xe),hn,j,0),Yn=z(cn(Nn+Wt,Xe),hn,j,0),fa(ki(ai,Yn),Tn(Yn-ai))):fa(0,j),Ni&&In?(Zt==1?(Nn=It,Wt=lt):(Nn=Et,Wt=et),hn=_[Te],ai=I(cn(Nn,gt),hn,ue,0),Yn=I(cn(Nn+Wt,gt),hn,ue,0),pa(ki(ai,Yn),Tn(Yn-ai))):pa(0,ue)}else $u()}else{let me=Tn(Yp-qp),Te=Tn(Jp-$p);if(R.ori==1){let gt=me;me=Te,Te=gt}Pn=Un.x&&me>=Un.dist,In=Un.y&&Te>=Un.dist;let Ve=Un.uni;Ve!=null?Pn&&In&&(Pn=me>=Ve,In=Te>=Ve,!Pn&&!In&&(Te>me?In=!0:Pn=!0)):Un.x&&Un.y&&(Pn||In)&&(Pn=In=!0);let Ge,Xe;Pn&&(R.ori==0?(Ge=Jr,Xe=Jt):(Ge=Kr,Xe=tn),fa(ki(Ge,Xe),Tn(Xe-Ge)),In||pa(0,ue)),In&&(R.ori==1?(Ge=Jr,Xe=Jt):(Ge=Kr,Xe=tn),pa(ki(Ge,Xe),Tn(Xe-Ge)),Pn||fa(0,j)),!Pn&&!In&&(fa(0,0),pa(0,0))}if(Un._x=Pn,Un._y=In,b==null){if(N){if(lm!=null){let[me,Te]=vn.scales;vn.values[0]=me!=null?Zi(R.ori==0?Jt:tn,me):null,vn.values[1]=Te!=null?Zi(R.ori==1?Jt:tn,Te):null}ga(fd,n,Jt,tn,B,be,D)}if(ht){let me=N&&vn.setSeries,Te=$e.prox;mr==null?Ss<=Te&&Ki(Ys,jr,!0,me):Ss>Te?Ki(null,jr,!0,me):Ys!=mr&&Ki(Ys,jr,!0,me)}}ge&&(ae.idx=D,Wu()),A!==!1&&Ln("setCursor")}let Js=null;Object.defineProperty(n,"rect",{get(){return Js==null&&ma(!1),Js}});function ma(b=!1){b?Js=null:(Js=m.getBoundingClientRect(),Ln("syncRect",Js))}function jp(b,A,N,D,X,j,ue){re._lock||qs&&b!=null&&b.movementX==0&&b.movementY==0||(Xu(b,A,N,D,X,j,ue,!1,b!=null),b!=null?gr(null,!0,!0):gr(A,!0,!1))}function Xu(b,A,N,D,X,j,ue,me,Te){if(Js==null&&ma(!1),ct(b),b!=null)N=b.clientX-Js.left,D=b.clientY-Js.top;else{if(N<0||D<0){Jt=-10,tn=-10;return}let[Ve,Ge]=vn.scales,Xe=A.cursor.sync,[gt,Ft]=Xe.values,[It,Et]=Xe.scales,[lt,et]=vn.match,Zt=A.axes[0].side%2==1,cn=R.ori==0?B:be,Nn=R.ori==1?B:be,Wt=Zt?j:X,hn=Zt?X:j,ai=Zt?D:N,Yn=Zt?N:D;if(It!=null?N=lt(Ve,It)?a(gt,_[Ve],cn,0):-10:N=cn*(ai/Wt),Et!=null?D=et(Ge,Et)?a(Ft,_[Ge],Nn,0):-10:D=Nn*(Yn/hn),R.ori==1){let Mi=N;N=D,D=Mi}}Te&&(A==null||A.cursor.event.type==fd)&&((N<=1||N>=B-1)&&(N=br(N,B)),(D<=1||D>=be-1)&&(D=br(D,be))),me?(qp=N,$p=D,[Jr,Kr]=re.move(n,N,D)):(Jt=N,tn=D)}let qu={width:0,height:0,left:0,top:0};function $u(){Tl(qu,!1)}let Qp,em,tm,nm;function im(b,A,N,D,X,j,ue){qs=!0,Pn=In=Un._x=Un._y=!1,Xu(b,A,N,D,X,j,ue,!0,!1),b!=null&&(ze(pd,xd,sm,!1),ga(ag,n,Jr,Kr,B,be,null));let{left:me,top:Te,width:Ve,height:Ge}=Kt;Qp=me,em=Te,tm=Ve,nm=Ge}function sm(b,A,N,D,X,j,ue){qs=Un._x=Un._y=!1,Xu(b,A,N,D,X,j,ue,!1,!0);let{left:me,top:Te,width:Ve,height:Ge}=Kt,Xe=Ve>0||Ge>0,gt=Qp!=me||em!=Te||tm!=Ve||nm!=Ge;if(Xe&&gt&&Tl(Kt),Un.setScale&&Xe&&gt){let Ft=me,It=Ve,Et=Te,lt=Ge;if(R.ori==1&&(Ft=Te,It=Ge,Et=me,lt=Ve),Pn&&$s(T,Zi(Ft,T),Zi(Ft+It,T)),In)for(let et in _){let Zt=_[et];et!=T&&Zt.from==null&&Zt.min!=Xt&&$s(et,Zi(Et+lt,et),Zi(Et,et))}$u()}else re.lock&&(re._lock=!re._lock,gr(A,!0,b!=null));b!=null&&(yt(pd,xd),ga(pd,n,Jt,tn,B,be,null))}function Zx(b,A,N,D,X,j,ue){if(re._lock)return;ct(b);let me=qs;if(qs){let Te=!0,Ve=!0,Ge=10,Xe,gt;R.ori==0?(Xe=Pn,gt=In):(Xe=In,gt=Pn),Xe&&gt&&(Te=Jt<=Ge||Jt>=B-Ge,Ve=tn<=Ge||tn>=be-Ge),Xe&&Te&&(Jt=Jt<Jr?0:B),gt&&Ve&&(tn=tn<Kr?0:be),gr(null,!0,!0),qs=!1}Jt=-10,tn=-10,J.fill(null),gr(null,!0,!0),me&&(qs=me)}function rm(b,A,N,D,X,j,ue){re._lock||(ct(b),da(),$u(),b!=null&&ga(hg,n,Jt,tn,B,be,null))}function om(){M.forEach(HM),V(n.width,n.height,!0)}wr(Xl,ro,om);let Qr={};Qr.mousedown=im,Qr.mousemove=jp,Qr.mouseup=sm,Qr.dblclick=rm,Qr.setSeries=(b,A,N,D)=>{let X=vn.match[2];N=X(n,A,N),N!=-1&&Ki(N,D,!0,!1)},pe&&(ze(ag,m,im),ze(fd,m,jp),ze(lg,m,b=>{ct(b),ma(!1)}),ze(cg,m,Zx),ze(hg,m,rm),Ad.add(n),n.syncRect=ma);let Al=n.hooks=i.hooks||{};function Ln(b,A,N){$n?Gt.push([b,A,N]):b in Al&&Al[b].forEach(D=>{D.call(null,n,A,N)})}(i.plugins||[]).forEach(b=>{for(let A in b.hooks)Al[A]=(Al[A]||[]).concat(b.hooks[A])});let am=(b,A,N)=>N,vn=_n({key:null,setSeries:!1,filters:{pub:bg,sub:bg},scales:[T,v[1]?v[1].scale:null],match:[Mg,Mg,am],values:[null,null]},re.sync);vn.match.length==2&&vn.match.push(am),re.sync=vn;let lm=vn.key,Yu=v0(lm);function ga(b,A,N,D,X,j,ue){vn.filters.pub(b,A,N,D,X,j,ue)&&Yu.pub(b,A,N,D,X,j,ue)}Yu.sub(n);function jx(b,A,N,D,X,j,ue){vn.filters.sub(b,A,N,D,X,j,ue)&&Qr[b](null,A,N,D,X,j,ue)}n.pub=jx;function Qx(){Yu.unsub(n),Ad.delete(n),st.clear(),Md(Xl,ro,om),c.remove(),Ae?.remove(),Ln("destroy")}n.destroy=Qx;function Ju(){Ln("init",i,e),ua(e||i.data,!1),G[T]?Vu(T,G[T]):da(),se=Kt.show&&(Kt.width>0||Kt.height>0),ne=ge=!0,V(i.width,i.height)}return v.forEach(Hr),M.forEach(xs),t?t instanceof HTMLElement?(t.appendChild(c),Ju()):t(n,Ju):Ju(),n}kn.assign=_n;kn.fmtNum=Dd;kn.rangeNum=ql;kn.rangeLog=Jl;kn.rangeAsinh=Ld;kn.orient=Tr;kn.pxRatio=Ut;kn.join=Db;kn.fmtDate=Ud,kn.tzDate=Xb;kn.sync=v0;{kn.addGap=AM,kn.clipGaps=jl;let i=kn.paths={points:w0};i.linear=T0,i.stepped=PM,i.bars=IM,i.spline=NM}function P0(i,e,t){let{time:n,values:s}=i,r=n.length;if(r<=2*t)return i;let o=e/t,a=Math.floor((n[0]??0)/o),l=Math.floor((n[r-1]??0)/o)-a+1,c={time:new Float64Array(2*l),values:s.map(()=>new Float32Array(2*l).fill(NaN))};for(let h=0;h<2*l;h++)c.time[h]=(a+h/2)*o;return s.forEach((h,u)=>{let d=c.values[u];if(!d)return;let f=0;for(let m=0;m<l;m++){let[y,p,g,v]=[1/0,-1/0,-1,-1];for(;f<r&&Math.floor((n[f]??0)/o)-a<=m;f++){let M=h[f]??NaN;M<y&&([y,g]=[M,f]),M>p&&([p,v]=[M,f])}g<0||(d[2*m]=g<=v?y:p,d[2*m+1]=g<=v?p:y)}}),c}function I0(i){let[e,t]=[1/0,-1/0];for(let n of i)for(let s=0;s<n.length;s++){let r=n[s]??NaN;r<e&&(e=r),r>t&&(t=r)}return e<=t?[e,t]:null}var nc=class{constructor(e){this.floor=e}floor;low=0;high=0;fit(e){let[t,n]=e?[Math.min(e[0],0),Math.max(e[1],0)]:[0,0],s=.08*Math.max(n-t,this.floor),[r,o]=[t<0?t-s:0,n>0||t===0?Math.max(n,t===0?this.floor:0)+s:0];return this.low=r<this.low?r:this.low+(r-this.low)*.04,this.high=o>this.high?o:this.high+(o-this.high)*.04,[this.low,Math.max(this.high,this.low+this.floor)]}};function L0(i,e){let n=[i.map(s=>/[",\n]/.test(s)?`"${s.replaceAll('"','""')}"`:s).join(",")];for(let s=0;s<e.time.length;s++){let r=e.values.map(o=>Number.isNaN(o[s])?"":String(Number((o[s]??NaN).toPrecision(7))));n.push([(e.time[s]??NaN).toFixed(4),...r].join(","))}return`${n.join(`
`)}
`}var WM={N:.05,J:.2},XM=[[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"]],qM=Array.from({length:22},(i,e)=>[1,2,5].map(t=>+`${t}e${e-14}`)).flat(),$M=.4;function Hd(i){return getComputedStyle(document.documentElement).getPropertyValue(i).trim()}function YM(i,e,t,n){let s=i.data[e],r=[],o=a=>i.valToPos(i.data[0][Math.min(Math.max(a,0),i.data[0].length-1)]??0,"x",!0);for(let a=t;s&&a<=n;a++){if(!Number.isNaN(s[a]))continue;let l=a;for(;l<n&&Number.isNaN(s[l+1]);)l++;(i.data[0][l+1]??1/0)-(i.data[0][a-1]??-1/0)>$M&&r.push([o(a-1),o(l+1)]),a=l}return r}var po=class{constructor(e,t,n,s,r,o,a){this.what=e;this.unit=t;this.lines=s;this.axis=new nc(n),this.readout=s.map(d=>k("span",{class:"reading",title:d.name}));let l=k("div",{class:"chart-area",role:"img","aria-label":`${e} of the last ${r} s`});this.element=k("figure",{class:"chart"},k("figcaption",{"data-tip":a,tabindex:0},k("strong",null,e),this.unitWords,k("span",{class:"readings tabular"},...this.readout)),l);let c=()=>Hd("--muted"),h=()=>Hd("--rule"),u=`11px ${Hd("--sans")||"system-ui"}`;this.plot=new kn({width:200,height:90,padding:[6,16,0,0],legend:{show:!1},cursor:{y:!1,drag:{x:!1,y:!1},points:{size:5},sync:{key:o}},scales:{x:{time:!1,range:[-r,0]},y:{range:()=>this.limits}},axes:[{stroke:c,font:u,size:20,gap:2,space:38,incrs:[1,2,5,10,20],grid:{stroke:h,width:1},ticks:{show:!1},values:(d,f)=>f.map(m=>m===0?"now":m===-r?"":`${On(m)} s`)},{stroke:c,font:u,size:38,gap:4,space:20,incrs:qM,grid:{stroke:h,width:1},ticks:{show:!1},values:(d,f,m,y,p)=>{let g=Math.max(0,-Math.floor(Math.log10(p/this.scale+1e-12)));return f.map(v=>On(v/this.scale,Math.min(g,3)))}}],series:[{},...s.map(d=>({label:d.name,stroke:d.colour,width:1.5,points:{show:!1},spanGaps:!1,gaps:(f,m,y,p)=>YM(f,m,y,p),...d.dash?{dash:d.dash}:{}}))],hooks:{setCursor:[()=>this.read()]}},[[],...s.map(()=>[])],l),this.observer=new ResizeObserver(([d])=>{let{width:f=0,height:m=0}=d?.contentRect??{};f>20&&m>20&&this.plot.setSize({width:Math.floor(f),height:Math.floor(m)})}),this.observer.observe(l)}what;unit;lines;element;unitWords=k("span",{class:"unit"});readout;plot;axis;scale=1;limits=[0,1];observer;draw(e,t){let n=new Float64Array(e.time.length);for(let a=0;a<n.length;a++)n[a]=(e.time[a]??0)-t;this.limits=this.axis.fit(I0(e.values));let s=Math.max(Math.abs(this.limits[0]),Math.abs(this.limits[1])),[r,o]=XM.find(([a])=>s>=a*(WM[this.unit]??1))??[1e-9,"n"];this.scale=r,Oe(this.unitWords,o+this.unit),this.lines.forEach((a,l)=>{let c=this.plot.series[l+1];c&&(c.width=a.width())}),this.plot.setData([n,...e.values],!0),this.read()}redraw(){this.plot.redraw(!1,!0)}get canvas(){return this.plot.ctx.canvas}get caption(){return`${this.what} [${this.unitWords.textContent??""}]`}get room(){return Math.max(this.plot.width-46,100)}dispose(){this.observer.disconnect(),this.plot.destroy(),this.element.remove()}read(){let e=this.plot.cursor.idx,t=this.plot.data[0].length-1;this.lines.forEach((n,s)=>{let r=this.readout[s],o=this.plot.data[s+1];if(!r||!o)return;let a=o[e??t],l=Math.abs((a??0)/this.scale),c=this.plot.width/this.lines.length<36?1:2,h=Math.max(0,l<9.995?c:l<99.95?c-1:0);Oe(r,a==null||Number.isNaN(a)?"–":On(a/this.scale,h)),r.style.setProperty("--user",n.colour())})}};var JM=20,mo=128;function N0(i){let{store:e}=i,t=k("div",{class:"charts charts-one"}),n=new Float64Array(mo),s=new Map,r=new Float32Array(mo).fill(NaN),o=0,a=null,l=[],c="",h=y=>getComputedStyle(document.documentElement).getPropertyValue(y).trim(),u=y=>is(i.link.get(),y),d=()=>{let y=e.state;if(!y||o&&y.time<=(n[o-1]??0))return;if(o===mo){n.copyWithin(0,1);for(let g of[...s.values(),r])g.copyWithin(0,1);o--}n[o]=y.time;for(let g of s.values())g[o]=NaN;for(let g of l){let v=s.get(Zn(g))??new Float32Array(mo).fill(NaN);s.set(Zn(g),v),v[o]=Fi(y,...g,"age_sum")??NaN}let p=i.link.get();r[o]=(p&&Fi(y,...p,"budget"))??NaN,o++;for(let[g,v]of s)v.subarray(0,o).every(Number.isNaN)&&s.delete(g)},f=()=>{let y=(e.state?.links??[]).map(([g,v])=>ns(g,v)),p=JSON.stringify([e.scene?.started,y]);p!==c&&(c.startsWith(JSON.stringify([e.scene?.started]).slice(0,-1))||([n,s,r,o]=[new Float64Array(mo),new Map,new Float32Array(mo).fill(NaN),0]),c=p,l=y,a?.dispose(),a=null,l.length&&(a=new po("Age sum","s",.01,[...l.map(g=>({name:os(...g),colour:()=>h(u(g)?"--accent":"--faint"),width:()=>u(g)?2.25:1})),{name:"budget",colour:()=>h("--warn"),width:()=>1.25,dash:[5,4]}],JM,"ages","Sum of the ages at both ends of every link. Select a link to highlight it and its budget"),t.replaceChildren(a.element))),d(),m()},m=()=>{if(!a||!o||t.offsetParent===null)return;let y={time:n.subarray(0,o),values:[...l.map(p=>s.get(Zn(p))?.subarray(0,o)??new Float32Array(o).fill(NaN)),r.subarray(0,o)]};a.draw(y,n[o-1]??0)};return e.on("state",f),e.on("settings",()=>a?.redraw()),i.link.on(()=>{r.fill(NaN),m()}),i.tab.on(m),t}var D0=" N·s/m",KM={spring:"Each link is a spring to the newest sample; damping pays for the samples’ ages, and is felt as drag.",paid:"Copies exchange what hands do and predict it; each push is paid from an energy account. Needs no damping.",wave:"Each link is a wave line: it adds some mass, and no drag beyond what damps its reflections.",tank:"Springs and dampers, paid from an energy tank that a damper fills."};function ZM(i,e){let t=i/e;return t<-1?"links are returning stored energy":t<1?"less than people notice":`${On(t,t<9.95?1:0)} times what people notice`}function F0(){let i=k("dd",{tabindex:0}),e=k("dd"),t=k("dd"),n=k("dd",{class:"means"}),s=(l,c)=>k("dt",{"data-tip":c,tabindex:0},l),r=s("energy on its way","Energy sent by link ends and not yet received"),o=s("felt drag","Drag of the link law, as a hand feels it"),a=k("dl",{class:"law tabular",hidden:!0},k("dt",null,"link law"),i,r,e,o,t,n);return{element:a,show(l,c){if(Mt(a,l!==null),!l)return;Oe(i,l.law),je(i,"data-tip",KM[l.law]??null),Mt(r,l.on_the_way!==null),Mt(e,l.on_the_way!==null),Oe(e,rs(l.on_the_way,"J",1e-9));let[h,u]=l.measured!==null?[l.measured,"measured"]:[l.predicted,"predicted"],d=l.measured!==null&&l.predicted!==null?`, predicted ${On(l.predicted,2)}`:"";Oe(t,h===null?"–":`${On(h,2)}${D0} ${u}${d}${c?", at each node":""}`),je(t,"data-how",h===null?null:u);let f=`from ${On(l.noticed,1)}${D0}`,m=h===null?"":c?`A hand feels the sum over all nodes that move with it; people notice drag ${f}.`:`${ZM(h,l.noticed)} (${f})`;Oe(n,h===null?"Known once the object moves.":m)}}}var jM="Safe (passive) means that whatever the users do, the session as a whole never returns more energy than hands put in, so nothing can start to oscillate by itself. This holds as long as each copy’s damping is at least what the ages on its links require. Damping is set for an age budget on each link; what the ages do not use is to spare. A link that exceeds its budget is guarded: it then spends only energy that it has saved. Laws other than springs need neither this damping nor a budget: they pay for their energy.",[k0,QM]=[.1,100],Wd={skin:1,bare:5};function U0(i){return Math.min(Number((k0*10**(i/10)).toPrecision(2)),95)}var Xd=i=>Math.round(10*Math.log10(i/k0)),O0=Xd(QM);function eS(i){let e=k("output",{class:"tabular"}),t=k("input",{type:"range",min:0,max:O0,step:1,value:Xd(Wd.bare),"aria-label":"Damping, as a share of what is needed"}),n=()=>{let o=`${U0(Number(t.value))} % of what is needed`;Oe(e,o),je(t,"aria-valuetext",o),t.style.setProperty("--share",`${Number(t.value)/O0*100}%`)};t.addEventListener("input",n),n();let s=_r("Lower the damping",[k("p",{class:"warning"},wn("warn",20),k("span",null,"With less damping than the delays need, nothing keeps energy from growing: copies start to shake by themselves, ever harder, until they are stopped. You will see this in the numbers and in the picture.")),k("p",null,"Do this only with simulated hands. Let go of any real device first."),k("label",{class:"slider"},k("span",null,"damping"),t,e),k("p",{class:"hint"},"Meanwhile, scripted hands let go. Damping stays lowered only while this page is open and responding. It is restored automatically when a copy runs away, and by one click on the banner.")],[{words:"Lower it",class:"button danger",act:()=>{i.act({what:"damping",fraction:Number((U0(Number(t.value))/100).toPrecision(3))})}},{words:"Keep it as it is",class:"button primary",act:()=>{},focus:!0}]),r;return{open:()=>{let{scene:o}=i.store;o&&o.started!==r&&(r=o.started,t.value=String(Xd(o.skin?Wd.skin:Wd.bare)),n()),s.open()}}}function B0(i){let{store:e}=i,t=eS(i),n=tt("Lower damping …",()=>t.open(),{icon:"warn",class:"button small danger",id:"lower",tip:"Shows what the damping is for"}),s=tt("Restore damping",()=>{i.act({what:"damping",fraction:1})},{class:"button small primary"}),{element:r,body:o}=Ei("margin","Margin",jM,n,s),a=k("tbody"),l=k("tbody"),c=F0();o.append(c.element,k("table",{class:"numbers"},k("thead",null,k("tr",null,...["link","age sum","budget","to spare",""].map(u=>k("th",{scope:"col"},u)))),a),N0(i),k("table",{class:"numbers"},k("thead",null,k("tr",null,k("th",{scope:"col"},"user"),k("th",{scope:"col","data-tip":"Largest damping coefficient of the copy",tabindex:0},"damping"),k("th",{scope:"col","data-tip":"Damping beyond what the current budgets need",tabindex:0},"damping margin"))),l));let h=()=>{let u=e.state,d=!!u&&u.damping<1;if(Mt(n,!d&&!!e.scene?.may.includes("damping")),Mt(s,d),n.disabled=s.disabled=!Nt(i,"damping"),!u||o.offsetParent===null)return;c.show(u.law,(e.scene?.nodes.count??1)>1);let f=u.links.map(([g,v])=>ns(g,v)),m=JSON.stringify([f,e.scene?.started]);a.dataset.key!==m&&(a.dataset.key=m,a.replaceChildren(...f.map(g=>k("tr",{"data-link":Zn(g)},k("th",{scope:"row"},tt(os(...g),()=>i.link.set(g),{class:"plain",label:`Open link ${os(...g)}`})),k("td"),k("td"),k("td",{class:"gauge"},k("i"),k("span")),k("td",{class:"word"}))))),f.forEach((g,v)=>{let M=a.children[v]?.children;if(!M)return;let _=ws(u,...g),E=Ol(u,...g);je(a.children[v],"data-condition",_),je(a.children[v],"data-chosen",is(g,i.link.get())?"":null),Oe(M[1],Gn(Fi(u,...g,"age_sum"))),Oe(M[2],Gn(Fi(u,...g,"budget")));let T=M[3];T.style.setProperty("--share",`${Math.round(100*Math.min(Math.max(1-(E??1),0),1))}%`),je(T,"data-level",E===null?null:E<0?"bad":E<.1?"warn":"good"),Oe(T.lastElementChild,E===null?"–":E<0?`${xn(-E,0)} over`:xn(E,0)),Oe(M[4],hi[_].words)});let y=Object.keys(u.members).map(Number).sort((g,v)=>g-v),p=JSON.stringify([y,e.scene?.started]);l.dataset.key!==p&&(l.dataset.key=p,l.replaceChildren(...y.map(g=>k("tr",null,k("th",{scope:"row"},k("span",{class:"badge tiny",style:`--user:var(--user-${g});--on-user:var(--on-user-${g})`},String(g+1))," ",Lt(e,g)),k("td"),k("td"))))),y.forEach((g,v)=>{let M=l.children[v]?.children,_=u.members[g];if(!M||!_)return;Oe(M[1],_.steps?`${On(_.damping,2)} N·s/m`:"–");let E=_.damping_margin;Oe(M[2],typeof E=="number"?xn(E):"–"),je(M[2],"data-level",typeof E=="number"?E<0?"bad":"good":null)})};return e.on("state",h),e.on("connection",h),i.tab.on(h),i.link.on(h),h(),r}var tS="The last 20 seconds of every copy, in the users’ colours; the user this page acts for has a thicker line. Displacement is the mean over all points (along x if the object moves along a line, else the distance), force is what the hand exerts on the copy, and energy is what the copy stores in motion and springs. Move over a plot to read values; otherwise the newest are shown. Saved data has every value.",nS=45,iS={kind:"x",what:"Displacement x",unit:"m",floor:.002,tip:"Mean displacement of each copy from rest, along x"},z0=[{kind:"displacement",what:"Displacement",unit:"m",floor:.002,tip:"Mean displacement of each copy from rest, as a distance"},{kind:"force",what:"Force",unit:"N",floor:.05,tip:"Force of each user’s hand on the copy"},{kind:"energy",what:"Energy",unit:"J",floor:1e-5,tip:"Energy in each copy: in motion and in springs"}];function V0(i,e){let t=URL.createObjectURL(e);k("a",{href:t,download:i}).click(),setTimeout(()=>URL.revokeObjectURL(t),1e3)}function G0(i){let{store:e}=i,t=null,n=0,s=[],r=[],o=()=>e.scene?.dimension===1?[iS,...z0.slice(1)]:z0,a=()=>[...["x","y","z"].slice(0,e.scene?.dimension??3).map(E=>({kind:E,head:`displacement_${E}_m`})),{kind:"force",head:"force_N"},{kind:"energy",head:"energy_J"}],l=0,c=-1,h=E=>t?.get(E)??{time:e.history.time(),values:r.map(T=>e.history.series(E,T))},u=()=>{if(t)return n;let E=e.frame;return E?E.time+Math.min((performance.now()-E.received)/1e3,e.connection==="open"?.25:0):0},d=()=>{t?t=null:(n=u(),t=new Map([...o(),...a()].map(({kind:T})=>[T,h(T)])));let E=f.querySelector("svg");E&&Vn(E,t?"play":"pause"),Oe(f.lastElementChild??f,t?"Resume":"Freeze"),f.setAttribute("aria-pressed",String(!!t)),p.toggleAttribute("data-frozen",!!t),c=-1},f=tt("Freeze",d,{icon:"pause",class:"button small",id:"freeze"}),m=tt("CSV",()=>{let E=a().map(({kind:S,head:O})=>({head:O,table:h(S)})),T=["time_s",...E.flatMap(({head:S})=>r.map(O=>`${S} ${O+1} ${Lt(e,O)}`))],x=L0(T,{time:E[0].table.time,values:E.flatMap(S=>S.table.values)});V0("cotouch.csv",new Blob([x],{type:"text/csv"}))},{icon:"save",class:"button small",label:"Save the data as CSV"}),y=tt("PNG",()=>{sS(i,s,r)?.toBlob(E=>E&&V0("cotouch.png",E))},{icon:"save",class:"button small",label:"Save the plots as an image"}),{element:p,body:g}=Ei("plots","Plots",tS,f,m,y);g.classList.add("charts");let v="",M=()=>{let E=e.scene,T=E?JSON.stringify([E.started,E.users,E.dimension]):"";if(T!==v){v=T,t&&d();for(let x of s)x.dispose();r=(E?.users??[]).map(x=>x.slot),s=o().map(({what:x,unit:S,floor:O,tip:L})=>new po(x,S,O,r.map(R=>({name:Lt(e,R),colour:()=>wi(R,Ks(e.settings.theme)),width:()=>R===e.slot?2.25:1.25})),e.history.seconds,"users",L)),g.replaceChildren(...s.map(x=>x.element)),c=-1}},_=E=>{if(requestAnimationFrame(_),E-l<nS||!s.length||g.offsetParent===null||c===e.history.version&&(t||e.connection!=="open")||t&&c>=0)return;l=E,c=e.history.version;let T=u();o().forEach(({kind:x},S)=>{let O=s[S];O?.draw(P0(h(x),e.history.seconds,O.room),T)})};return e.on("scene",M),e.on("settings",()=>{for(let E of s)E.redraw()}),M(),requestAnimationFrame(_),{element:p,freeze:d}}function sS(i,e,t){if(!e[0]?.canvas)return null;let s=getComputedStyle(document.documentElement),r=devicePixelRatio||1,o=22*r,a=k("canvas",{width:Math.max(...e.map(f=>f.canvas.width))+2*o,height:e.reduce((f,m)=>f+m.canvas.height+o,3*o)}),l=a.getContext("2d");if(!l)return null;l.fillStyle=s.getPropertyValue("--panel"),l.fillRect(0,0,a.width,a.height),l.textBaseline="middle";let c=(f,m,y,p,g)=>(l.font=`${p} ${12*r}px system-ui, sans-serif`,l.fillStyle=g,l.fillText(f,m,y),l.measureText(f).width),h=s.getPropertyValue("--ink"),u=o;for(let f of t)l.fillStyle=wi(f,Ks(i.store.settings.theme)),l.fillRect(u,o-5*r,10*r,10*r),u+=15*r,u+=c(Lt(i.store,f),u,o,400,h)+16*r;let d=2*o;for(let f of e)c(f.caption,o,d,600,h),l.drawImage(f.canvas,o,d+o/2),d+=f.canvas.height+o;return a}var H0=350;function W0(i){let e=k("div",{class:"tip",role:"tooltip",id:"tip",hidden:!0});i.append(e);let t=0,n=null,s=()=>{clearTimeout(t),e.hidden=!0,n?.removeAttribute("aria-describedby"),n=null},r=a=>{let l=a.getAttribute("data-tip");if(!l||!a.isConnected)return;Oe(e,l),(a.closest("dialog")??i).append(e),e.hidden=!1,a.setAttribute("aria-describedby","tip");let c=a.getBoundingClientRect(),h=e.getBoundingClientRect(),u=Math.min(Math.max(c.left+c.width/2-h.width/2,8),innerWidth-h.width-8),d=c.bottom+8+h.height<innerHeight;e.style.left=`${u}px`,e.style.top=`${d?c.bottom+8:c.top-h.height-8}px`},o=(a,l)=>{let c=a.target?.closest?.("[data-tip]")??null;c!==n&&(s(),c&&(n=c,t=window.setTimeout(()=>r(c),l)))};document.addEventListener("pointerover",a=>{a.pointerType!=="touch"&&o(a,H0)}),document.addEventListener("focusin",a=>{a.target.matches(":focus-visible")&&o(a,H0)}),document.addEventListener("focusout",s),document.addEventListener("pointerdown",s,!0),document.addEventListener("keydown",s,!0),document.addEventListener("scroll",s,!0)}function X0(i,e){let{store:t}=i,n=xr("Tool",[{value:"grab",words:"Grab",icon:"grab",tip:"Take hold of a point and drag it (B switches tools)"},{value:"ball",words:"Ball",icon:"ball",tip:"Push with a ball; Shift + wheel changes its size"},{value:"blade",words:"Blade",icon:"blade",tip:"Cut away from you; Shift + wheel changes the depth"}],u=>t.set({tool:u})),s=xr("Copies",[{value:"overlay",words:"Overlaid",icon:"overlay",tip:"All copies in one place (S)"},{value:"side",words:"Side by side",icon:"side",tip:"Each copy on its own: see how late the others are (S)"}],u=>t.set({layout:u})),r=k("option",{value:"plain"},"Plain"),o=k("select",{"aria-label":"Colour of the object","data-tip":"What the colours show (C)"},k("option",{value:"displacement"},"Displacement"),k("option",{value:"stress"},"Stretch"),r);o.addEventListener("change",()=>t.set({colour:o.value}));let a=tt("Ghosts",()=>t.set({ghosts:!t.settings.ghosts}),{icon:"ghosts",class:"button small toggle",tip:"Show the others’ copies over yours"}),l=tt("",e,{icon:"reset",class:"button small bare",label:"Reset the view",tip:"Reset the view (0)"}),c=k("div",{class:"toolbar",id:"toolbar",role:"toolbar","aria-label":"Picture"},k("span",{class:"space-only"},n.element),k("span",{class:"space-only"},s.element),k("span",{class:"space-only select"},o),a,l),h=()=>{let{settings:u,scene:d}=t;n.mark(t.tool);for(let f of n.element.querySelectorAll("[data-value]"))f.hidden=!t.tools.some(m=>m===f.dataset.value);s.mark(u.layout),r.textContent=d?.parts.length?"Bodies":"Plain",o.value=t.colour,je(a,"aria-pressed",String(u.ghosts)),je(c,"data-dimension",d?String(d.dimension):null),a.disabled=d?.dimension!==1&&u.layout==="side"};return t.on("settings",h),t.on("scene",h),h(),c}function Aa(i,e){let t=Math.min(i.left+i.width,e.left+e.width)-Math.max(i.left,e.left),n=Math.min(i.top+i.height,e.top+e.height)-Math.max(i.top,e.top);return Math.max(t,0)*Math.max(n,0)}function q0(i,e,t){let[n,s]=[t.left+t.width-i.width,t.top+t.height-i.height],r=(h,u)=>e.flatMap(d=>[d[h]-i[u]-12,d[h],d[h]+d[u]-i[u],d[h]+d[u]+12]),o=(h,u,d)=>[...new Set([u,d,...h.filter(f=>f>u&&f<d)])],a=e[0]??t,l={left:t.left,top:Math.max(s,t.top)},c=1/0;for(let h of o(r("left","width"),t.left,Math.max(n,t.left)))for(let u of o(r("top","height"),t.top,Math.max(s,t.top))){let d={left:h,top:u,...i},f=e.reduce((p,g,v)=>p+(v?1:4)*Aa(d,g),0),m=Math.hypot(h+i.width/2-a.left-a.width/2,u+i.height/2-a.top-a.height/2),y=1e3*f+m;y<c&&([l,c]=[{left:h,top:u},y])}return l}var Jd="cotouch.tour",rS="#energy, #plots, #network",oS=200,sc=(i,e)=>t=>Nt(t,i)?null:e,Y0=i=>i.store.frame?.copies.find(e=>e.slot===i.store.slot),tr=i=>{let e=Y0(i);return e?.mode==="grab"||e?.mode==="ball"||e?.mode==="pose"},$0=i=>Math.hypot(...Y0(i)?.force??[0,0,0]),ic=sc("hand","This page may only watch; continue with →."),qd=i=>i.map(([e,t])=>Zn(ns(e,t))).sort().join(" "),$d=({store:{state:i}})=>i?.links.filter(([e,t])=>no(i,e,t))??[],Bi=[{title:"Take hold",words:"This is one object, held by several people. Each of them has a copy of it; yours is the solid one.",task:"Press on the object and drag.",where:"#stage",needs:ic,done:i=>tr(i)&&$0(i)>.02},{title:"Let go",words:"What you feel is a spring between your pointer and the point you hold. The others feel you through springs between the copies.",task:"Release, and watch the object swing back and come to rest.",where:"#stage",needs:ic,done:(i,e)=>(tr(i)&&(e.held=!0),!!e.held&&!tr(i))},{title:"See the delay",words:"Samples take tens of milliseconds to travel. The other copies do what yours did, but later.",task:"Choose Side by side (or Ghosts), then drag again and watch the others.",where:"#stage-frame",needs:ic,done:(i,e)=>{let{layout:t,ghosts:n}=i.store.settings,s=e.first??=`${t} ${n}`;return(t==="side"||`${t} ${n}`!==s)&&(e.seen=!0),!!e.seen&&tr(i)}},{title:"Pull against somebody",words:"You can tell a scripted hand what to do. Two users who pull against each other feel each other’s force through the network.",task:"Expand another user, set the hand to Hold or Pull, and drag the other way.",where:i=>i.told?"#stage":"#users",sees:"#stage, #users",tab:"users",needs:ic,done:(i,e)=>{let{state:t,slot:n}=i.store;return Object.entries(t?.members??{}).some(([r,o])=>Number(r)!==n&&(o.hand==="hold"||o.hand==="pull"))&&(e.told=!0),!!e.told&&tr(i)&&$0(i)>.02}},{title:"Look at a link",words:"Lines link users. The number is the age of the samples that a copy works with. Damping is set so that this age does no harm.",task:"Select a link to see both ends.",where:"#network",sees:"#link",tab:"network",done:i=>i.link.get()!==null},{title:"Cut a link",words:"Networks fail. When samples stop arriving, both ends let go of their spring without a jolt, and everybody else carries on.",task:"Press Cut, and watch the line and the verdict at the top.",where:"#link, #network",sees:"#network, #verdict",tab:"network",needs:sc("cut","Links cannot be cut from here; continue with →."),done:i=>$d(i).length>0},{title:"Reconnect it",words:"When samples arrive again, both ends first catch up and save energy; they couple only when both can pay for it.",task:"Press Reconnect, and wait until the link is coupled again.",where:"#link, #network",sees:"#network, #verdict",tab:"network",needs:(i,e)=>Nt(i,"cut")?$d(i).length||e.cut?null:"No link is cut. Go back with ← to cut one, or continue with →.":"Links cannot be reconnected from here; continue with →.",done:(i,e)=>{let{state:t}=i.store,n=e.cut??=[];for(let s of $d(i))n.some(([r,o])=>r===s[0]&&o===s[1])||n.push(s);return n.length>0&&n.every(([s,r])=>ws(t,s,r)==="coupled")}},{title:"Choose bad links",words:"It matters which users are linked. With the same number of links, copies agree soonest with the best choice and latest with the worst.",task:"Choose Worst, drag and let go; then choose Best.",where:"#topology",sees:"#stage, #network",tab:"network",needs:sc("links","Links cannot be chosen from here; continue with →."),done:({store:i},e)=>{let{state:t}=i;if(!t)return!1;let n=qd(t.links);return t.choices.worst&&qd(t.choices.worst)===n&&(e.worst=!0),!!e.worst&&!!t.choices.best&&qd(t.choices.best)===n}},{title:"Follow the energy",words:"Every joule is accounted for: put in by hands, added by delays, damped, or still in the copies. Both bars are always equally long.",task:"Drag the object, and see what you put in.",where:"#energy",sees:"#stage",tab:"energy",done:(i,e)=>{let t=Object.values(i.store.state?.members??{}).reduce((s,r)=>s+Math.abs(r.supplied??0),0),n=e.first??=t;return i.tab.get()==="energy"&&(Math.abs(t-n)>1e-6||!Nt(i,"hand"))}},{title:"Remove the guarantee",words:"With less damping than the delays need, nothing keeps energy from growing. See for yourself: within seconds a copy runs away, is caught, and full damping is restored.",task:"Lower the damping and watch. Restore it, or wait until it is restored automatically.",where:i=>i.lowered?"#stage-frame":"#margin",sees:"#stage-frame, #margin",tab:"margin",needs:sc("damping","Damping cannot be changed from here; this was the last step."),done:({store:i},e)=>{let t=i.state?.damping??1;return t<1&&(e.lowered=!0),!!e.lowered&&t===1}}];function aS(){try{let{step:i=0,over:e=!1}=JSON.parse(localStorage.getItem(Jd)??"{}");return{step:Math.min(Math.max(Math.floor(Number(i))||0,0),Bi.length-1),over:e===!0}}catch{return{step:0,over:!1}}}function Yd(i,e){try{localStorage.setItem(Jd,JSON.stringify({step:i,over:e}))}catch{}}function J0(i,e){let t=0,n={},s=!1,r=new Set,o=k("div",{class:"tour-hole",hidden:!0,"aria-hidden":"true"}),a=k("p",{class:"tour-number tabular"}),l=k("h2",{id:"tour-title"}),c=k("p",{id:"tour-words"}),h=wn("play",16),u=k("span",null),d=k("p",{class:"tour-task",role:"status"},h,u),f=k("div",{class:"tour-dots","aria-hidden":"true"},...Bi.map(()=>k("i"))),m=tt("Back",()=>S(t-1),{class:"button small",label:"Previous step (←)"}),y=tt("Next",()=>t+1<Bi.length?S(t+1):L(!0),{class:"button small",label:"Next step (→)",id:"tour-next"}),p=tt("",()=>L(!1),{icon:"close",class:"button bare",label:"Leave the tour (Esc); you can resume it later"}),g=k("div",{class:"tour-card",id:"tour",role:"dialog","aria-modal":"false","aria-labelledby":"tour-title","aria-describedby":"tour-words",tabindex:-1,hidden:!0},k("div",{class:"panel-head"},a,k("div",{class:"grow"}),p),l,c,d,k("div",{class:"tour-foot"},f,k("div",{class:"grow"}),m,y)),v=tt("Start",()=>O(),{class:"button small primary"}),M=tt("Not now",()=>{Mt(_,!1),Yd(t,!0)},{class:"button small"}),_=k("div",{class:"tour-offer",id:"tour-offer",role:"region","aria-label":"Tour",hidden:!0},wn("tour",18),k("span",null,"New here? Take a two-minute tour."),v,M);e.append(o,g,_);let E=R=>R?R.split(", ").flatMap(U=>[...document.querySelector(U)?.getClientRects()??[]]):[],T=()=>{let R=Bi[t];if(!s||!R)return;let U=E(typeof R.where=="string"?R.where:R.where(n))[0];if(o.hidden=!U,!U)return;let z=4,[I,G]=[Math.max(U.left-z,2),Math.max(U.top-z,2)];Object.assign(o.style,{left:`${I}px`,top:`${G}px`,width:`${Math.min(U.right+z,innerWidth-2)-I}px`,height:`${Math.min(U.bottom+z,innerHeight-2)-G}px`});let q={left:8,top:8,width:innerWidth-16,height:innerHeight-16},H=[U,...E(R.sees??rS),...E(".bar")],he=ee=>{g.toggleAttribute("data-wide",ee);let{width:J,height:ae}=g.getBoundingClientRect();return{...q0({width:J,height:ae},H,q),width:J,height:ae}},Y=he(!1);if(Aa(Y,U)>0){let ee=he(!0);Aa(ee,U)<Aa(Y,U)?Y=ee:g.removeAttribute("data-wide")}g.style.left=`${Y.left}px`,g.style.top=`${Y.top}px`},x=()=>{let R=Bi[t];if(!s||!R)return;let U=R.needs?.(i,n)??null;!r.has(t)&&U===null&&R.done(i,n)&&(r=new Set([...r,t]),i.say(t+1<Bi.length?"Done. Continue when you like.":"That was the last step.","good"));let z=r.has(t);je(g,"data-done",z?"":null),Vn(h,z?"tick":U?"wait":"play"),Oe(u,U??R.task),je(y,"class",`button small${z?" primary":""}`),Oe(y.lastElementChild??y,t+1===Bi.length?"Finish":z?"Next":"Skip"),T()},S=R=>{t=Math.min(Math.max(R,0),Bi.length-1);let U=Bi[t];U&&(n={},Yd(t,!1),U.tab&&i.tab.set(U.tab),Oe(a,`Step ${t+1} of ${Bi.length}`),Oe(l,U.title),Oe(c,U.words),m.disabled=t===0,[...f.children].forEach((z,I)=>je(z,"class",I===t?"here":r.has(I)?"done":null)),x())},O=()=>{s=!0,Mt(_,!1),g.hidden=!1,S(aS().step),g.focus({preventScroll:!0})},L=R=>{s=!1,g.hidden=o.hidden=!0,Yd(R?0:t,!0),R?r=new Set:i.say(`You can resume the tour at step ${t+1}.`),document.getElementById("tour-open")?.focus()};return document.addEventListener("keydown",R=>{if(!s||document.querySelector("dialog[open]"))return;let U=g.contains(document.activeElement)||document.activeElement===document.body;if(R.key==="Escape"&&U&&!tr(i))L(!1);else if(R.key==="ArrowRight"&&U&&!tr(i))t+1<Bi.length?S(t+1):L(!0);else if(R.key==="ArrowLeft"&&U&&!tr(i))S(t-1);else return;R.preventDefault(),R.stopPropagation()},!0),addEventListener("resize",T),setInterval(x,oS),{open:O,invite:()=>{let R=!1;try{R=localStorage.getItem(Jd)===null}catch{}R&&!s&&Mt(_,!0)}}}var lS={users:"Users",network:"Network",plots:"Plots",energy:"Energy",margin:"Margin",events:"Events"},K0=4500;function cS(){let i=wn("good",16),e=k("span",null),t=k("div",{class:"toast",hidden:!0,"aria-hidden":"true"},i,e),n=k("div",{class:"unseen",role:"status","aria-live":"polite",id:"spoken"}),s=0;return{element:k("div",{class:"toasts"},t,n),say(r,o="info"){let a=r.slice(0,1).toUpperCase()+r.slice(1);Oe(e,a),Oe(n,a),je(t,"data-level",o),Vn(i,o==="info"?"wait":o),t.hidden=!1,clearTimeout(s),s=window.setTimeout(()=>t.hidden=!0,o==="bad"?2*K0:K0)}}}function hS(i){let e=Sm.map(s=>{let r=k("button",{type:"button",role:"tab",id:`tab-${s}`,"aria-controls":s,"data-tab":s},lS[s]);return r.addEventListener("click",()=>i.tab.set(s)),r}),t=k("div",{class:"tabs",role:"tablist","aria-label":"Instruments"},...e);t.addEventListener("keydown",s=>{let r={ArrowRight:1,ArrowLeft:-1}[s.key];if(!r)return;let o=e.filter(c=>c.getClientRects().length),a=o.indexOf(document.activeElement),l=o[(a+r+o.length)%o.length];l?.focus(),l?.dataset.tab&&i.tab.set(l.dataset.tab),s.preventDefault(),s.stopPropagation()});let n=()=>{let s=i.tab.get();document.documentElement.dataset.tab=s;let r=["energy","margin","events"].includes(s);document.documentElement.dataset.side=r?s:document.documentElement.dataset.side??"energy";let o=matchMedia("(max-width: 899px)").matches?s:document.documentElement.dataset.side;for(let a of e)je(a,"aria-selected",String(a.dataset.tab===o)),a.tabIndex=a.dataset.tab===o?0:-1};return i.tab.on(n),matchMedia("(max-width: 899px)").addEventListener("change",n),n(),t}function uS(i,e,t){let n=s=>{let r=i.aiming.get();if(!r||!e.contains(s.target)||(s.preventDefault(),s.stopImmediatePropagation(),s.type!=="pointerdown"))return;let o=t()?.aim(s.clientX,s.clientY)??null;if(!o)return i.say("The object is not there; click closer to it.","warn");i.aiming.set(null);let a=i.store.frame?.copies.find(c=>c.slot===r.slot)?.node??-1,l=a>=0?a:i.store.scene?.skin?.node[o.point]??o.point;i.act({what:"hand",slot:r.slot,mode:"pull",node:l,to:o.to})};for(let s of["pointerdown","pointermove","pointerup"])addEventListener(s,n,!0);addEventListener("keydown",s=>{s.key!=="Escape"||s.defaultPrevented||(i.aiming.get()?i.aiming.set(null):document.querySelector("dialog[open]")||i.link.set(null))}),i.aiming.on(s=>e.toggleAttribute("data-aiming",s!==null))}function dS(i){let e=-1/0,t="";i.store.on("state",()=>{let n=i.store.state;if(!n)return;let s=n.events.at(-1);s&&s.time>e&&(e>-1/0&&Oe(document.getElementById("spoken")??document.createElement("i"),s.text),e=s.time),t&&t!==n.verdict.level&&Oe(document.getElementById("spoken")??document.createElement("i"),n.verdict.text),t=n.verdict.level}),i.store.on("scene",()=>{i.store.state||([e,t]=[-1/0,""])})}function Z0(i,e,t){let n=cS(),s={store:e,connection:t,link:new vr(null),opened:new vr(null),tab:new vr("energy"),aiming:new vr(null),say:n.say,async act(p,g=!1){let v=await t.do(p);return(!v.ok||!g)&&n.say(v.text||(v.ok?"Done.":"The server refused."),v.ok?"good":"bad"),v.ok}},r=null,o=k("div",{id:"stage"}),a=()=>r?.reset(),l=Vm(s),c=J0(s,i),h=G0(s),u=Im(s,{tour:c.open,invite:l.open,keys:()=>d.open()}),d=Xm(s,{tour:c.open,invite:l.open,record:u.record,freeze:h.freeze,reset:a}),f=k("main",{class:"layout"},Hm(s),k("div",{id:"stage-frame"},o,X0(s,a),ig(s),k("div",{class:"notices"},n.element,Cm(s))),h.element,ng(s),hS(s),Fm(s),B0(s),Um(s)),m=tt("To the object",()=>o.querySelector(".ct-canvas")?.focus(),{class:"skip"});i.classList.add("shell"),i.prepend(m,u.element,f),matchMedia("(max-width: 899px)").matches&&s.tab.set("users"),s.opened.on(p=>p!==null&&r?.pulse(p)),uS(s,o,()=>r),dS(s),W0(i);let y=e.on("scene",()=>{y(),c.invite()});return{stageElement:o,attach:p=>r=p}}function Kd(i,e,t){let n=i.emulated[`${e}-${t}`];if(n?.cut)return null;if(n&&n.delay+n.jitter>0)return n.delay+n.jitter;let s=i.ends[`${e}-${t}`];return s?.age_sum!=null?s.age_sum/2:s?.round_trip!=null?s.round_trip/2:n?n.delay:null}function rc(i,e){let t=new Map([[e,0]]),n=new Set;for(;;){let s=-1;for(let[r,o]of t)!n.has(r)&&(s<0||o<t.get(s))&&(s=r);if(s<0)return t;n.add(s);for(let[r,o]of i.links){if(r!==s&&o!==s)continue;let a=r===s?o:r,l=Kd(i,a,s);if(l===null)continue;let c=t.get(s)+l;c<(t.get(a)??1/0)&&t.set(a,c)}}}function cs(i){return i<.9995?`${Math.round(i*1e3)} ms`:`${i.toFixed(1)} s`}function oc(i,e=i){let t=Math.abs(e),[n,s]=t<95e-5?[1e6,"µm"]:t<.095?[1e3,"mm"]:t<.95?[100,"cm"]:[1,"m"],r=i*n;return`${r.toFixed(Math.abs(r)<9.95&&r!==Math.round(r)?1:0).replace("-","−")} ${s}`}function ac(i){return`${i.toFixed(i<.995?2:i<9.95?1:0)} N`}function go(i){let e=10**Math.floor(Math.log10(Math.max(i,1e-12)));for(let t of[1,2,5,10])if(t*e>=i*.9999)return t*e;return 10*e}var Zd={displacement:"displacement",stress:"stretch",plain:""},[fS,pS]=[440,220],yo=class{root=document.createElement("div");key=document.createElement("figure");what=document.createElement("figcaption");most=document.createElement("span");hint=document.createElement("p");lines=document.createElement("div");off;constructor(e,t,n){this.root.className="ct-furniture",this.key.className="ct-legend";let s=document.createElement("i");s.style.background=`linear-gradient(to right, ${Rl.join(", ")})`;let r=document.createElement("span");r.textContent="0",this.key.append(this.what,r,s,this.most),this.hint.className="ct-hint",this.hint.textContent=t.scene?.acts?n.act:n.look,this.hint.hidden=!this.hint.textContent,this.lines.className="ct-lines",this.root.append(this.lines,this.key,this.hint),e.append(this.root),this.off=t.on("frame",()=>{let o=t.frame?.copies.find(a=>a.slot===t.slot)?.mode;(o==="grab"||o==="ball"||o==="pose")&&this.told()})}told(){this.hint.hidden=!0,this.off()}legend(e,t){this.key.hidden=!Zd[e],this.what.textContent!==Zd[e]&&(this.what.textContent=Zd[e]),this.most.textContent!==t&&(this.most.textContent=t)}covered(e,t,n){let s=Math.min(fS/2,.44*n);return!this.hint.hidden&&e<n/2+s&&t>n/2-s?94:!this.key.hidden&&t>n-pS?44:0}rules(e){this.lines.replaceChildren(...e.map(({x:t,y:n,width:s,height:r})=>{let o=document.createElement("i");return Object.assign(o.style,{left:`${t}px`,top:`${n}px`,width:`${s}px`,height:`${r}px`}),o}))}dispose(){this.off(),this.root.remove()}};var mS=[[148,158,172],[232,160,30],[208,48,42]],gS=[[122,133,150],[245,185,66],[255,107,91]];function Ca(i,e){let t=e?gS:mS,n=Math.min(Math.max(i,0),1)/.4,s=n<1?0:1;return`#${t[s].map((o,a)=>Math.round(o+(t[s+1][a]-o)*(s?(n-1)/1.5:n))).map(o=>o.toString(16).padStart(2,"0")).join("")}`}var vo=class{held=!1;told=0;read(){let e=this.first();if(!e)return null;let t=!!e.buttons[0]?.pressed,n={x:e.axes[0]??0,y:e.axes[1]??0,depth:-(e.axes[3]??0),pressed:t&&!this.held,released:!t&&this.held};return this.held=t,n}rumble(e){let t=performance.now(),n=this.first()?.vibrationActuator;if(!n||t-this.told<90||e<.03)return;this.told=t;let s=Math.min(e,1);n.playEffect("dual-rumble",{duration:90*1.5,strongMagnitude:s**2,weakMagnitude:s}).catch(()=>{})}first(){try{return navigator.getGamepads?.().find(e=>e?.connected)??null}catch{return null}}};var Iy=0,Ff=1,Ly=2;var al=1,Ny=2,Jo=3,fr=0,ni=1,ms=2,Or=0,Ko=1,Uf=2,Of=3,kf=4,Dy=5;var kr=100,Fy=101,Uy=102,Oy=103,ky=104,By=200,zy=201,Vy=202,Gy=203,Bf=204,zf=205,Hy=206,Wy=207,Xy=208,qy=209,$y=210,Yy=211,Jy=212,Ky=213,Zy=214,zc=0,Vc=1,Gc=2,No=3,Hc=4,Wc=5,Do=6,Xc=7,Vf=0,jy=1,Qy=2,gs=0,Gf=1,Hf=2,Wf=3,Xf=4,qf=5,$f=6,Yf=7;var Jf=300,Br=301,Zo=302,wh=303,Eh=304,Fo=1e3,us=1001,qc=1002,Fn=1003,ev=1004;var ll=1005;var An=1006,Th=1007;var _i=1008;var ii=1009,Kf=1010,Zf=1011,jo=1012,Ah=1013,Hi=1014,Wi=1015,Xi=1016,Ch=1017,Rh=1018,zr=1020,jf=35902,Qf=35899,ep=1021,tp=1022,bi=1023,Ds=1026,zs=1027,np=1028,Ph=1029,pr=1030,Ih=1031;var Lh=1033,cl=33776,hl=33777,ul=33778,dl=33779,Nh=35840,Dh=35841,Fh=35842,Uh=35843,Oh=36196,kh=37492,Bh=37496,zh=37488,Vh=37489,fl=37490,Gh=37491,Hh=37808,Wh=37809,Xh=37810,qh=37811,$h=37812,Yh=37813,Jh=37814,Kh=37815,Zh=37816,jh=37817,Qh=37818,eu=37819,tu=37820,nu=37821,iu=36492,su=36494,ru=36495,ou=36283,au=36284,pl=36285,lu=36286;var ka=2300,$c=2301,Oc=2302,wf=2303,Ef=2400,Tf=2401,Af=2402;var tv=3200;var ip=0,nv=1,Vs="",gi="srgb",Ba="srgb-linear",za="linear",Bt="srgb";var kc=7680;var iv=519,sv=512,rv=513,ov=514,sp=515,av=516,lv=517,rp=518,op=519,cu=35044,ml=35048;var ap="300 es",Pi=2e3,Va=2001;function yS(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function vS(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ga(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function cv(){let i=Ga("canvas");return i.style.display="block",i}var j0={},Uo=null;function lp(...i){let e="THREE."+i.shift();Uo?Uo("log",e,...i):console.log(e,...i)}function hv(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function it(...i){i=hv(i);let e="THREE."+i.shift();if(Uo)Uo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function ut(...i){i=hv(i);let e="THREE."+i.shift();if(Uo)Uo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Fa(...i){let e=i.join(" ");e in j0||(j0[e]=!0,it(...i))}function uv(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var dv={[zc]:zc,[Gc]:Do,[Hc]:Hc,[No]:Wc,[Vc]:Vc,[Do]:Gc,[Xc]:Xc,[Wc]:No},ds=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Hn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Bc=Math.PI/180,Yc=180/Math.PI;function Qo(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Hn[i&255]+Hn[i>>8&255]+Hn[i>>16&255]+Hn[i>>24&255]+"-"+Hn[e&255]+Hn[e>>8&255]+"-"+Hn[e>>16&15|64]+Hn[e>>24&255]+"-"+Hn[t&63|128]+Hn[t>>8&255]+"-"+Hn[t>>16&255]+Hn[t>>24&255]+Hn[n&255]+Hn[n>>8&255]+Hn[n>>16&255]+Hn[n>>24&255]).toLowerCase()}function Tt(i,e,t){return Math.max(e,Math.min(t,i))}function xS(i,e){return(i%e+e)%e}function jd(i,e,t){return(1-t)*i+t*e}function fv(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function cp(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function _S(i,e){if(e.constructor===Float32Array)return i;let t=cp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function bS(i,e){if(e.constructor===Float32Array)return i;let t=cp(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Fe=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Tt(this.x,e.x,t.x),this.y=Tt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Tt(this.x,e,t),this.y=Tt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Tt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Tt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},fn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],m=r[o+2],y=r[o+3];if(u!==y||l!==d||c!==f||h!==m){let p=l*d+c*f+h*m+u*y;p<0&&(d=-d,f=-f,m=-m,y=-y,p=-p);let g=1-a;if(p<.9995){let v=Math.acos(p),M=Math.sin(v);g=Math.sin(g*v)/M,a=Math.sin(a*v)/M,l=l*g+d*a,c=c*g+f*a,h=h*g+m*a,u=u*g+y*a}else{l=l*g+d*a,c=c*g+f*a,h=h*g+m*a,u=u*g+y*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],m=r[o+3];return e[t]=a*m+h*u+l*f-c*d,e[t+1]=l*m+h*d+c*u-a*f,e[t+2]=c*m+h*f+a*d-l*u,e[t+3]=h*m-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u-d*f*m;break;case"YXZ":this._x=d*h*u+c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u+d*f*m;break;case"ZXY":this._x=d*h*u-c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u-d*f*m;break;case"ZYX":this._x=d*h*u-c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u+d*f*m;break;case"YZX":this._x=d*h*u+c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u-d*f*m;break;case"XZY":this._x=d*h*u-c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u+d*f*m;break;default:it("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Tt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},F=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Q0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Q0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Tt(this.x,e.x,t.x),this.y=Tt(this.y,e.y,t.y),this.z=Tt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Tt(this.x,e,t),this.y=Tt(this.y,e,t),this.z=Tt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Tt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Qd.copy(this).projectOnVector(e),this.sub(Qd)}reflect(e){return this.sub(Qd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Tt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Qd=new F,Q0=new fn,mt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],m=n[8],y=s[0],p=s[3],g=s[6],v=s[1],M=s[4],_=s[7],E=s[2],T=s[5],x=s[8];return r[0]=o*y+a*v+l*E,r[3]=o*p+a*M+l*T,r[6]=o*g+a*_+l*x,r[1]=c*y+h*v+u*E,r[4]=c*p+h*M+u*T,r[7]=c*g+h*_+u*x,r[2]=d*y+f*v+m*E,r[5]=d*p+f*M+m*T,r[8]=d*g+f*_+m*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,m=t*u+n*d+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/m;return e[0]=u*y,e[1]=(s*c-h*n)*y,e[2]=(a*n-s*o)*y,e[3]=d*y,e[4]=(h*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=f*y,e[7]=(n*l-c*t)*y,e[8]=(o*t-n*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Fa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ef.makeScale(e,t)),this}rotate(e){return Fa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ef.makeRotation(-e)),this}translate(e,t){return Fa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ef.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},ef=new mt,ey=new mt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),ty=new mt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function MS(){let i={enabled:!0,workingColorSpace:Ba,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Bt&&(s.r=Ns(s.r),s.g=Ns(s.g),s.b=Ns(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Bt&&(s.r=Lo(s.r),s.g=Lo(s.g),s.b=Lo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Vs?za:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ba]:{primaries:e,whitePoint:n,transfer:za,toXYZ:ey,fromXYZ:ty,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:gi},outputColorSpaceConfig:{drawingBufferColorSpace:gi}},[gi]:{primaries:e,whitePoint:n,transfer:Bt,toXYZ:ey,fromXYZ:ty,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:gi}}}),i}var Rt=MS();function Ns(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Lo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var xo,Jc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{xo===void 0&&(xo=Ga("canvas")),xo.width=e.width,xo.height=e.height;let s=xo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=xo}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ga("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ns(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Ns(t[n]/255)*255):t[n]=Ns(t[n]);return{data:t,width:e.width,height:e.height}}else return it("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},SS=0,Oo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:SS++}),this.uuid=Qo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(tf(s[o].image)):r.push(tf(s[o]))}else r=tf(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function tf(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Jc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(it("Texture: Unable to serialize Texture."),{})}var wS=0,nf=new F,si=class i extends ds{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=us,s=us,r=An,o=_i,a=bi,l=ii,c=i.DEFAULT_ANISOTROPY,h=Vs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:wS++}),this.uuid=Qo(),this.name="",this.source=new Oo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Fe(0,0),this.repeat=new Fe(1,1),this.center=new Fe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new mt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(nf).x}get height(){return this.source.getSize(nf).y}get depth(){return this.source.getSize(nf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){it(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){it(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Jf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Fo:e.x=e.x-Math.floor(e.x);break;case us:e.x=e.x<0?0:1;break;case qc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Fo:e.y=e.y-Math.floor(e.y);break;case us:e.y=e.y<0?0:1;break;case qc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};si.DEFAULT_IMAGE=null;si.DEFAULT_MAPPING=Jf;si.DEFAULT_ANISOTROPY=1;var on=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],m=l[9],y=l[2],p=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-y)<.01&&Math.abs(m-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+y)<.1&&Math.abs(m+p)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,_=(f+1)/2,E=(g+1)/2,T=(h+d)/4,x=(u+y)/4,S=(m+p)/4;return M>_&&M>E?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=T/n,r=x/n):_>E?_<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(_),n=T/s,r=S/s):E<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),n=x/r,s=S/r),this.set(n,s,r,t),this}let v=Math.sqrt((p-m)*(p-m)+(u-y)*(u-y)+(d-h)*(d-h));return Math.abs(v)<.001&&(v=1),this.x=(p-m)/v,this.y=(u-y)/v,this.z=(d-h)/v,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Tt(this.x,e.x,t.x),this.y=Tt(this.y,e.y,t.y),this.z=Tt(this.z,e.z,t.z),this.w=Tt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Tt(this.x,e,t),this.y=Tt(this.y,e,t),this.z=Tt(this.z,e,t),this.w=Tt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Tt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Kc=class extends ds{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:An,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new on(0,0,e,t),this.scissorTest=!1,this.viewport=new on(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new si({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:An,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Oo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ti=class extends Kc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Ha=class extends si{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Fn,this.minFilter=Fn,this.wrapR=us,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Zc=class extends si{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Fn,this.minFilter=Fn,this.wrapR=us,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Ht=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,m,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,m,y,p)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,m,y,p){let g=this.elements;return g[0]=e,g[4]=t,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=m,g[11]=y,g[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/_o.setFromMatrixColumn(e,0).length(),r=1/_o.setFromMatrixColumn(e,1).length(),o=1/_o.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,m=a*h,y=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+m*c,t[5]=d-y*c,t[9]=-a*l,t[2]=y-d*c,t[6]=m+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,m=c*h,y=c*u;t[0]=d+y*a,t[4]=m*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-m,t[6]=y+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,m=c*h,y=c*u;t[0]=d-y*a,t[4]=-o*u,t[8]=m+f*a,t[1]=f+m*a,t[5]=o*h,t[9]=y-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,m=a*h,y=a*u;t[0]=l*h,t[4]=m*c-f,t[8]=d*c+y,t[1]=l*u,t[5]=y*c+d,t[9]=f*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,m=a*l,y=a*c;t[0]=l*h,t[4]=y-d*u,t[8]=m*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+m,t[10]=d-y*u}else if(e.order==="XZY"){let d=o*l,f=o*c,m=a*l,y=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+y,t[5]=o*h,t[9]=f*u-m,t[2]=m*u-f,t[6]=a*h,t[10]=y*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(ES,e,TS)}lookAt(e,t,n){let s=this.elements;return pi.subVectors(e,t),pi.lengthSq()===0&&(pi.z=1),pi.normalize(),nr.crossVectors(n,pi),nr.lengthSq()===0&&(Math.abs(n.z)===1?pi.x+=1e-4:pi.z+=1e-4,pi.normalize(),nr.crossVectors(n,pi)),nr.normalize(),lc.crossVectors(pi,nr),s[0]=nr.x,s[4]=lc.x,s[8]=pi.x,s[1]=nr.y,s[5]=lc.y,s[9]=pi.y,s[2]=nr.z,s[6]=lc.z,s[10]=pi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],m=n[2],y=n[6],p=n[10],g=n[14],v=n[3],M=n[7],_=n[11],E=n[15],T=s[0],x=s[4],S=s[8],O=s[12],L=s[1],R=s[5],U=s[9],z=s[13],I=s[2],G=s[6],q=s[10],H=s[14],he=s[3],Y=s[7],ee=s[11],J=s[15];return r[0]=o*T+a*L+l*I+c*he,r[4]=o*x+a*R+l*G+c*Y,r[8]=o*S+a*U+l*q+c*ee,r[12]=o*O+a*z+l*H+c*J,r[1]=h*T+u*L+d*I+f*he,r[5]=h*x+u*R+d*G+f*Y,r[9]=h*S+u*U+d*q+f*ee,r[13]=h*O+u*z+d*H+f*J,r[2]=m*T+y*L+p*I+g*he,r[6]=m*x+y*R+p*G+g*Y,r[10]=m*S+y*U+p*q+g*ee,r[14]=m*O+y*z+p*H+g*J,r[3]=v*T+M*L+_*I+E*he,r[7]=v*x+M*R+_*G+E*Y,r[11]=v*S+M*U+_*q+E*ee,r[15]=v*O+M*z+_*H+E*J,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],m=e[3],y=e[7],p=e[11],g=e[15],v=l*f-c*d,M=a*f-c*u,_=a*d-l*u,E=o*f-c*h,T=o*d-l*h,x=o*u-a*h;return t*(y*v-p*M+g*_)-n*(m*v-p*E+g*T)+s*(m*M-y*E+g*x)-r*(m*_-y*T+p*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],m=e[12],y=e[13],p=e[14],g=e[15],v=t*a-n*o,M=t*l-s*o,_=t*c-r*o,E=n*l-s*a,T=n*c-r*a,x=s*c-r*l,S=h*y-u*m,O=h*p-d*m,L=h*g-f*m,R=u*p-d*y,U=u*g-f*y,z=d*g-f*p,I=v*z-M*U+_*R+E*L-T*O+x*S;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/I;return e[0]=(a*z-l*U+c*R)*G,e[1]=(s*U-n*z-r*R)*G,e[2]=(y*x-p*T+g*E)*G,e[3]=(d*T-u*x-f*E)*G,e[4]=(l*L-o*z-c*O)*G,e[5]=(t*z-s*L+r*O)*G,e[6]=(p*_-m*x-g*M)*G,e[7]=(h*x-d*_+f*M)*G,e[8]=(o*U-a*L+c*S)*G,e[9]=(n*L-t*U-r*S)*G,e[10]=(m*T-y*_+g*v)*G,e[11]=(u*_-h*T-f*v)*G,e[12]=(a*O-o*R-l*S)*G,e[13]=(t*R-n*O+s*S)*G,e[14]=(y*M-m*E-p*v)*G,e[15]=(h*E-u*M+d*v)*G,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,m=r*u,y=o*h,p=o*u,g=a*u,v=l*c,M=l*h,_=l*u,E=n.x,T=n.y,x=n.z;return s[0]=(1-(y+g))*E,s[1]=(f+_)*E,s[2]=(m-M)*E,s[3]=0,s[4]=(f-_)*T,s[5]=(1-(d+g))*T,s[6]=(p+v)*T,s[7]=0,s[8]=(m+M)*x,s[9]=(p-v)*x,s[10]=(1-(d+y))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=_o.set(s[0],s[1],s[2]).length(),a=_o.set(s[4],s[5],s[6]).length(),l=_o.set(s[8],s[9],s[10]).length();r<0&&(o=-o),zi.copy(this);let c=1/o,h=1/a,u=1/l;return zi.elements[0]*=c,zi.elements[1]*=c,zi.elements[2]*=c,zi.elements[4]*=h,zi.elements[5]*=h,zi.elements[6]*=h,zi.elements[8]*=u,zi.elements[9]*=u,zi.elements[10]*=u,t.setFromRotationMatrix(zi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Pi,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),m,y;if(l)m=r/(o-r),y=o*r/(o-r);else if(a===Pi)m=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Va)m=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Pi,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),m,y;if(l)m=1/(o-r),y=o/(o-r);else if(a===Pi)m=-2/(o-r),y=-(o+r)/(o-r);else if(a===Va)m=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},_o=new F,zi=new Ht,ES=new F(0,0,0),TS=new F(1,1,1),nr=new F,lc=new F,pi=new F,ny=new Ht,iy=new fn,ar=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(Tt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Tt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Tt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Tt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Tt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Tt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:it("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return ny.makeRotationFromQuaternion(e),this.setFromRotationMatrix(ny,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return iy.setFromEuler(this),this.setFromQuaternion(iy,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ar.DEFAULT_ORDER="XYZ";var Wa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},AS=0,sy=new F,bo=new fn,As=new Ht,cc=new F,Ra=new F,CS=new F,RS=new fn,ry=new F(1,0,0),oy=new F(0,1,0),ay=new F(0,0,1),ly={type:"added"},PS={type:"removed"},Mo={type:"childadded",child:null},sf={type:"childremoved",child:null},ri=class i extends ds{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:AS++}),this.uuid=Qo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new F,t=new ar,n=new fn,s=new F(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ht},normalMatrix:{value:new mt}}),this.matrix=new Ht,this.matrixWorld=new Ht,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Wa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return bo.setFromAxisAngle(e,t),this.quaternion.multiply(bo),this}rotateOnWorldAxis(e,t){return bo.setFromAxisAngle(e,t),this.quaternion.premultiply(bo),this}rotateX(e){return this.rotateOnAxis(ry,e)}rotateY(e){return this.rotateOnAxis(oy,e)}rotateZ(e){return this.rotateOnAxis(ay,e)}translateOnAxis(e,t){return sy.copy(e).applyQuaternion(this.quaternion),this.position.add(sy.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(ry,e)}translateY(e){return this.translateOnAxis(oy,e)}translateZ(e){return this.translateOnAxis(ay,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(As.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?cc.copy(e):cc.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ra.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?As.lookAt(Ra,cc,this.up):As.lookAt(cc,Ra,this.up),this.quaternion.setFromRotationMatrix(As),s&&(As.extractRotation(s.matrixWorld),bo.setFromRotationMatrix(As),this.quaternion.premultiply(bo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ut("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(ly),Mo.child=e,this.dispatchEvent(Mo),Mo.child=null):ut("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(PS),sf.child=e,this.dispatchEvent(sf),sf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),As.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),As.multiply(e.parent.matrixWorld)),e.applyMatrix4(As),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(ly),Mo.child=e,this.dispatchEvent(Mo),Mo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ra,e,CS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ra,RS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),m=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ri.DEFAULT_UP=new F(0,1,0);ri.DEFAULT_MATRIX_AUTO_UPDATE=!0;ri.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ei=class extends ri{constructor(){super(),this.isGroup=!0,this.type="Group"}},IS={type:"move"},ko=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ei,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ei,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new F,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new F),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ei,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new F,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new F,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let p=t.getJointPose(y,n),g=this._getHandJoint(c,y);p!==null&&(g.matrix.fromArray(p.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=p.radius),g.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,m=.005;c.inputState.pinching&&d>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(IS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new ei;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},pv={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ir={h:0,s:0,l:0},hc={h:0,s:0,l:0};function rf(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Pt=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=gi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Rt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=Rt.workingColorSpace){return this.r=e,this.g=t,this.b=n,Rt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=Rt.workingColorSpace){if(e=xS(e,1),t=Tt(t,0,1),n=Tt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=rf(o,r,e+1/3),this.g=rf(o,r,e),this.b=rf(o,r,e-1/3)}return Rt.colorSpaceToWorking(this,s),this}setStyle(e,t=gi){function n(r){r!==void 0&&parseFloat(r)<1&&it("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:it("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);it("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=gi){let n=pv[e.toLowerCase()];return n!==void 0?this.setHex(n,t):it("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ns(e.r),this.g=Ns(e.g),this.b=Ns(e.b),this}copyLinearToSRGB(e){return this.r=Lo(e.r),this.g=Lo(e.g),this.b=Lo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=gi){return Rt.workingToColorSpace(Wn.copy(this),e),Math.round(Tt(Wn.r*255,0,255))*65536+Math.round(Tt(Wn.g*255,0,255))*256+Math.round(Tt(Wn.b*255,0,255))}getHexString(e=gi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Rt.workingColorSpace){Rt.workingToColorSpace(Wn.copy(this),t);let n=Wn.r,s=Wn.g,r=Wn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=Rt.workingColorSpace){return Rt.workingToColorSpace(Wn.copy(this),t),e.r=Wn.r,e.g=Wn.g,e.b=Wn.b,e}getStyle(e=gi){Rt.workingToColorSpace(Wn.copy(this),e);let t=Wn.r,n=Wn.g,s=Wn.b;return e!==gi?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(ir),this.setHSL(ir.h+e,ir.s+t,ir.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(ir),e.getHSL(hc);let n=jd(ir.h,hc.h,t),s=jd(ir.s,hc.s,t),r=jd(ir.l,hc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Wn=new Pt;Pt.NAMES=pv;var Lr=class extends ri{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ar,this.environmentIntensity=1,this.environmentRotation=new ar,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Vi=new F,Cs=new F,of=new F,Rs=new F,So=new F,wo=new F,cy=new F,af=new F,lf=new F,cf=new F,hf=new on,uf=new on,df=new on,Ls=class i{constructor(e=new F,t=new F,n=new F){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Vi.subVectors(e,t),s.cross(Vi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Vi.subVectors(s,t),Cs.subVectors(n,t),of.subVectors(e,t);let o=Vi.dot(Vi),a=Vi.dot(Cs),l=Vi.dot(of),c=Cs.dot(Cs),h=Cs.dot(of),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,m=(o*h-a*l)*d;return r.set(1-f-m,m,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Rs)===null?!1:Rs.x>=0&&Rs.y>=0&&Rs.x+Rs.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Rs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Rs.x),l.addScaledVector(o,Rs.y),l.addScaledVector(a,Rs.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return hf.setScalar(0),uf.setScalar(0),df.setScalar(0),hf.fromBufferAttribute(e,t),uf.fromBufferAttribute(e,n),df.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(hf,r.x),o.addScaledVector(uf,r.y),o.addScaledVector(df,r.z),o}static isFrontFacing(e,t,n,s){return Vi.subVectors(n,t),Cs.subVectors(e,t),Vi.cross(Cs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Vi.subVectors(this.c,this.b),Cs.subVectors(this.a,this.b),Vi.cross(Cs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;So.subVectors(s,n),wo.subVectors(r,n),af.subVectors(e,n);let l=So.dot(af),c=wo.dot(af);if(l<=0&&c<=0)return t.copy(n);lf.subVectors(e,s);let h=So.dot(lf),u=wo.dot(lf);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(So,o);cf.subVectors(e,r);let f=So.dot(cf),m=wo.dot(cf);if(m>=0&&f<=m)return t.copy(r);let y=f*c-l*m;if(y<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(n).addScaledVector(wo,a);let p=h*m-f*u;if(p<=0&&u-h>=0&&f-m>=0)return cy.subVectors(r,s),a=(u-h)/(u-h+(f-m)),t.copy(s).addScaledVector(cy,a);let g=1/(p+y+d);return o=y*g,a=d*g,t.copy(n).addScaledVector(So,o).addScaledVector(wo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},fs=class{constructor(e=new F(1/0,1/0,1/0),t=new F(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Gi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Gi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Gi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Gi):Gi.fromBufferAttribute(r,o),Gi.applyMatrix4(e.matrixWorld),this.expandByPoint(Gi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),uc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),uc.copy(n.boundingBox)),uc.applyMatrix4(e.matrixWorld),this.union(uc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Gi),Gi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Pa),dc.subVectors(this.max,Pa),Eo.subVectors(e.a,Pa),To.subVectors(e.b,Pa),Ao.subVectors(e.c,Pa),sr.subVectors(To,Eo),rr.subVectors(Ao,To),Ar.subVectors(Eo,Ao);let t=[0,-sr.z,sr.y,0,-rr.z,rr.y,0,-Ar.z,Ar.y,sr.z,0,-sr.x,rr.z,0,-rr.x,Ar.z,0,-Ar.x,-sr.y,sr.x,0,-rr.y,rr.x,0,-Ar.y,Ar.x,0];return!ff(t,Eo,To,Ao,dc)||(t=[1,0,0,0,1,0,0,0,1],!ff(t,Eo,To,Ao,dc))?!1:(fc.crossVectors(sr,rr),t=[fc.x,fc.y,fc.z],ff(t,Eo,To,Ao,dc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Gi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Gi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ps[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ps[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ps[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ps[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ps[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ps[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ps[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ps[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ps),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ps=[new F,new F,new F,new F,new F,new F,new F,new F],Gi=new F,uc=new fs,Eo=new F,To=new F,Ao=new F,sr=new F,rr=new F,Ar=new F,Pa=new F,dc=new F,fc=new F,Cr=new F;function ff(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Cr.fromArray(i,r);let a=s.x*Math.abs(Cr.x)+s.y*Math.abs(Cr.y)+s.z*Math.abs(Cr.z),l=e.dot(Cr),c=t.dot(Cr),h=n.dot(Cr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var bn=new F,pc=new Fe,LS=0,Mn=class extends ds{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:LS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=cu,this.updateRanges=[],this.gpuType=Wi,this.version=0,this._normalizationScale=e!==void 0?cp(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)pc.fromBufferAttribute(this,t),pc.applyMatrix3(e),this.setXY(t,pc.x,pc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)bn.fromBufferAttribute(this,t),bn.applyMatrix3(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)bn.fromBufferAttribute(this,t),bn.applyMatrix4(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)bn.fromBufferAttribute(this,t),bn.applyNormalMatrix(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)bn.fromBufferAttribute(this,t),bn.transformDirection(e),this.setXYZ(t,bn.x,bn.y,bn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):_S(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):bS(e,this.array)}};var Xa=class extends Mn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var qa=class extends Mn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var $t=class extends Mn{constructor(e,t,n){super(new Float32Array(e),t,n)}},NS=new fs,Ia=new F,pf=new F,lr=class{constructor(e=new F,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):NS.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ia.subVectors(e,this.center);let t=Ia.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Ia,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(pf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ia.copy(e.center).add(pf)),this.expandByPoint(Ia.copy(e.center).sub(pf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},DS=0,Ri=new Ht,mf=new ri,Co=new F,mi=new fs,La=new fs,Dn=new F,pn=class i extends ds{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:DS++}),this.uuid=Qo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(yS(e)?qa:Xa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new mt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ri.makeRotationFromQuaternion(e),this.applyMatrix4(Ri),this}rotateX(e){return Ri.makeRotationX(e),this.applyMatrix4(Ri),this}rotateY(e){return Ri.makeRotationY(e),this.applyMatrix4(Ri),this}rotateZ(e){return Ri.makeRotationZ(e),this.applyMatrix4(Ri),this}translate(e,t,n){return Ri.makeTranslation(e,t,n),this.applyMatrix4(Ri),this}scale(e,t,n){return Ri.makeScale(e,t,n),this.applyMatrix4(Ri),this}lookAt(e){return mf.lookAt(e),mf.updateMatrix(),this.applyMatrix4(mf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Co).negate(),this.translate(Co.x,Co.y,Co.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new $t(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&it("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new fs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ut("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new F(-1/0,-1/0,-1/0),new F(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];mi.setFromBufferAttribute(r),this.morphTargetsRelative?(Dn.addVectors(this.boundingBox.min,mi.min),this.boundingBox.expandByPoint(Dn),Dn.addVectors(this.boundingBox.max,mi.max),this.boundingBox.expandByPoint(Dn)):(this.boundingBox.expandByPoint(mi.min),this.boundingBox.expandByPoint(mi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ut('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new lr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ut("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new F,1/0);return}if(e){let n=this.boundingSphere.center;if(mi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];La.setFromBufferAttribute(a),this.morphTargetsRelative?(Dn.addVectors(mi.min,La.min),mi.expandByPoint(Dn),Dn.addVectors(mi.max,La.max),mi.expandByPoint(Dn)):(mi.expandByPoint(La.min),mi.expandByPoint(La.max))}mi.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Dn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Dn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Dn.fromBufferAttribute(a,c),l&&(Co.fromBufferAttribute(e,c),Dn.add(Co)),s=Math.max(s,n.distanceToSquared(Dn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ut('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ut("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Mn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let O=0;O<n.count;O++)a[O]=new F,l[O]=new F;let h=new F,u=new F,d=new F,f=new Fe,m=new Fe,y=new Fe,p=new F,g=new F;function v(O,L,R){c[O]=c[L]=c[R]=1,h.fromBufferAttribute(n,O),u.fromBufferAttribute(n,L),d.fromBufferAttribute(n,R),f.fromBufferAttribute(r,O),m.fromBufferAttribute(r,L),y.fromBufferAttribute(r,R),u.sub(h),d.sub(h),m.sub(f),y.sub(f);let U=1/(m.x*y.y-y.x*m.y);isFinite(U)&&(p.copy(u).multiplyScalar(y.y).addScaledVector(d,-m.y).multiplyScalar(U),g.copy(d).multiplyScalar(m.x).addScaledVector(u,-y.x).multiplyScalar(U),a[O].add(p),a[L].add(p),a[R].add(p),l[O].add(g),l[L].add(g),l[R].add(g))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let O=0,L=M.length;O<L;++O){let R=M[O],U=R.start,z=R.count;for(let I=U,G=U+z;I<G;I+=3)v(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let _=new F,E=new F,T=new F,x=new F;function S(O){T.fromBufferAttribute(s,O),x.copy(T);let L=a[O];_.copy(L),_.sub(T.multiplyScalar(T.dot(L))).normalize(),E.crossVectors(x,L);let U=E.dot(l[O])<0?-1:1;o.setXYZW(O,_.x,_.y,_.z,U)}for(let O=0,L=n.count;O<L;++O)c[O]&&S(O);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Mn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new F,r=new F,o=new F,a=new F,l=new F,c=new F,h=new F,u=new F;if(e)for(let d=0,f=e.count;d<f;d+=3){let m=e.getX(d+0),y=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Dn.fromBufferAttribute(e,t),Dn.normalize(),e.setXYZ(t,Dn.x,Dn.y,Dn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,m=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*h;for(let g=0;g<h;g++)d[m++]=c[f++]}return new Mn(d,h,u)}if(this.index===null)return it("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var gf=new F,FS=new F,US=new mt,yi=class{constructor(e=new F(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=gf.subVectors(n,t).cross(FS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(gf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||US.getNormalMatrix(e),s=this.coplanarPoint(gf).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},OS=0,Fs=class extends ds{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:OS++}),this.uuid=Qo(),this.name="",this.type="Material",this.blending=Ko,this.side=fr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Bf,this.blendDst=zf,this.blendEquation=kr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Pt(0,0,0),this.blendAlpha=0,this.depthFunc=No,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=iv,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=kc,this.stencilZFail=kc,this.stencilZPass=kc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){it(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){it(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Pt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new yi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Fe().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Fe().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Is=new F,yf=new F,mc=new F,gc=new F,ps=class{constructor(e=new F,t=new F(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Is)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Is.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Is.copy(this.origin).addScaledVector(this.direction,t),Is.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){yf.copy(e).add(t).multiplyScalar(.5),mc.copy(t).sub(e).normalize(),gc.copy(this.origin).sub(yf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(mc),a=gc.dot(this.direction),l=-gc.dot(mc),c=gc.lengthSq(),h=Math.abs(1-o*o),u,d,f,m;if(h>0)if(u=o*l-a,d=o*a-l,m=r*h,u>=0)if(d>=-m)if(d<=m){let y=1/h;u*=y,d*=y,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-m?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=m?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(yf).addScaledVector(mc,d),f}intersectSphere(e,t){if(e.radius<0)return null;Is.subVectors(e.center,this.origin);let n=Is.dot(this.direction),s=Is.dot(Is)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Is)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,m=t.x-o.x,y=t.y-o.y,p=t.z-o.z,g=n.x-o.x,v=n.y-o.y,M=n.z-o.z,_=Math.abs(l),E=Math.abs(c),T=Math.abs(h),x,S,O,L,R,U,z,I,G,q,H,he;if(_>=E&&_>=T?(O=l,U=u,G=m,he=g,l>=0?(x=c,S=h,L=d,R=f,z=y,I=p,q=v,H=M):(x=h,S=c,L=f,R=d,z=p,I=y,q=M,H=v)):E>=T?(O=c,U=d,G=y,he=v,c>=0?(x=h,S=l,L=f,R=u,z=p,I=m,q=M,H=g):(x=l,S=h,L=u,R=f,z=m,I=p,q=g,H=M)):(O=h,U=f,G=p,he=M,h>=0?(x=l,S=c,L=u,R=d,z=m,I=y,q=g,H=v):(x=c,S=l,L=d,R=u,z=y,I=m,q=v,H=g)),O===0)return null;let Y=x/O,ee=S/O,J=1/O,ae=L-Y*U,re=R-ee*U,Q=z-Y*G,pe=I-ee*G,ye=q-Y*he,Ae=H-ee*he,Se=ye*pe-Ae*Q,He=ae*Ae-re*ye,ot=Q*re-pe*ae;if(s){if(Se<0||He<0||ot<0)return null}else if((Se<0||He<0||ot<0)&&(Se>0||He>0||ot>0))return null;let Ze=Se+He+ot;if(Ze===0)return null;let at=J*(Se*U+He*G+ot*he);return(Ze>0?at<0:at>0)?null:this.at(at/Ze,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},jc=class extends Fs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Pt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ar,this.combine=Vf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},hy=new Ht,Rr=new ps,yc=new lr,uy=new F,vc=new F,xc=new F,_c=new F,vf=new F,bc=new F,dy=new F,Mc=new F,en=class extends ri{constructor(e=new pn,t=new jc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){bc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(vf.fromBufferAttribute(u,e),o?bc.addScaledVector(vf,h):bc.addScaledVector(vf.sub(t),h))}t.add(bc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),yc.copy(n.boundingSphere),yc.applyMatrix4(r),Rr.copy(e.ray).recast(e.near),!(yc.containsPoint(Rr.origin)===!1&&(Rr.intersectSphere(yc,uy)===null||Rr.origin.distanceToSquared(uy)>(e.far-e.near)**2))&&(hy.copy(r).invert(),Rr.copy(e.ray).applyMatrix4(hy),!(n.boundingBox!==null&&Rr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Rr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,y=d.length;m<y;m++){let p=d[m],g=o[p.materialIndex],v=Math.max(p.start,f.start),M=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let _=v,E=M;_<E;_+=3){let T=a.getX(_),x=a.getX(_+1),S=a.getX(_+2);s=Sc(this,g,e,n,c,h,u,T,x,S),s&&(s.faceIndex=Math.floor(_/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let p=m,g=y;p<g;p+=3){let v=a.getX(p),M=a.getX(p+1),_=a.getX(p+2);s=Sc(this,o,e,n,c,h,u,v,M,_),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,y=d.length;m<y;m++){let p=d[m],g=o[p.materialIndex],v=Math.max(p.start,f.start),M=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let _=v,E=M;_<E;_+=3){let T=_,x=_+1,S=_+2;s=Sc(this,g,e,n,c,h,u,T,x,S),s&&(s.faceIndex=Math.floor(_/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let p=m,g=y;p<g;p+=3){let v=p,M=p+1,_=p+2;s=Sc(this,o,e,n,c,h,u,v,M,_),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function kS(i,e,t,n,s,r,o,a){let l;if(e.side===ni?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===fr,a),l===null)return null;Mc.copy(a),Mc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Mc);return c<t.near||c>t.far?null:{distance:c,point:Mc.clone(),object:i}}function Sc(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,vc),i.getVertexPosition(l,xc),i.getVertexPosition(c,_c);let h=kS(i,e,t,n,vc,xc,_c,dy);if(h){let u=new F;Ls.getBarycoord(dy,vc,xc,_c,u),s&&(h.uv=Ls.getInterpolatedAttribute(s,a,l,c,u,new Fe)),r&&(h.uv1=Ls.getInterpolatedAttribute(r,a,l,c,u,new Fe)),o&&(h.normal=Ls.getInterpolatedAttribute(o,a,l,c,u,new F),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new F,materialIndex:0};Ls.getNormal(vc,xc,_c,d.normal),h.face=d,h.barycoord=u}return h}var Bo=class extends si{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Fn,h=Fn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Pr=new lr,BS=new Fe(.5,.5),wc=new F,Nr=class{constructor(e=new yi,t=new yi,n=new yi,s=new yi,r=new yi,o=new yi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Pi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],m=r[8],y=r[9],p=r[10],g=r[11],v=r[12],M=r[13],_=r[14],E=r[15];if(s[0].setComponents(c-o,f-h,g-m,E-v).normalize(),s[1].setComponents(c+o,f+h,g+m,E+v).normalize(),s[2].setComponents(c+a,f+u,g+y,E+M).normalize(),s[3].setComponents(c-a,f-u,g-y,E-M).normalize(),n)s[4].setComponents(l,d,p,_).normalize(),s[5].setComponents(c-l,f-d,g-p,E-_).normalize();else if(s[4].setComponents(c-l,f-d,g-p,E-_).normalize(),t===Pi)s[5].setComponents(c+l,f+d,g+p,E+_).normalize();else if(t===Va)s[5].setComponents(l,d,p,_).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Pr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Pr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Pr)}intersectsSprite(e){Pr.center.set(0,0,0);let t=BS.distanceTo(e.center);return Pr.radius=.7071067811865476+t,Pr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Pr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(wc.x=s.normal.x>0?e.max.x:e.min.x,wc.y=s.normal.y>0?e.max.y:e.min.y,wc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(wc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},fy=new Ht,Qc=class i{constructor(){this.coordinateSystem=Pi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];fy.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Nr),n[s].setFromProjectionMatrix(fy,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Nr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var zo=class extends Fs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Pt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},eh=new F,th=new F,py=new Ht,Na=new ps,Ec=new lr,xf=new F,my=new F,nh=class extends ri{constructor(e=new pn,t=new zo){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)eh.fromBufferAttribute(t,s-1),th.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=eh.distanceTo(th);e.setAttribute("lineDistance",new $t(n,1))}else it("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ec.copy(n.boundingSphere),Ec.applyMatrix4(s),Ec.radius+=r,e.ray.intersectsSphere(Ec)===!1)return;py.copy(s).invert(),Na.copy(e.ray).applyMatrix4(py);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),m=Math.min(h.count,o.start+o.count);for(let y=f,p=m-1;y<p;y+=c){let g=h.getX(y),v=h.getX(y+1),M=Tc(this,e,Na,l,g,v,y);M&&t.push(M)}if(this.isLineLoop){let y=h.getX(m-1),p=h.getX(f),g=Tc(this,e,Na,l,y,p,m-1);g&&t.push(g)}}else{let f=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let y=f,p=m-1;y<p;y+=c){let g=Tc(this,e,Na,l,y,y+1,y);g&&t.push(g)}if(this.isLineLoop){let y=Tc(this,e,Na,l,m-1,f,m-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Tc(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(eh.fromBufferAttribute(a,s),th.fromBufferAttribute(a,r),t.distanceSqToSegment(eh,th,xf,my)>n)return;xf.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(xf);if(!(c<e.near||c>e.far))return{distance:c,point:my.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var gy=new F,yy=new F,Us=class extends nh{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)gy.fromBufferAttribute(t,s),yy.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+gy.distanceTo(yy);e.setAttribute("lineDistance",new $t(n,1))}else it("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ih=class extends Fs{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Pt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},vy=new Ht,Cf=new ps,Ac=new lr,Cc=new F,Vo=class extends ri{constructor(e=new pn,t=new ih){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ac.copy(n.boundingSphere),Ac.applyMatrix4(s),Ac.radius+=r,e.ray.intersectsSphere(Ac)===!1)return;vy.copy(s).invert(),Cf.copy(e.ray).applyMatrix4(vy);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let m=d,y=f;m<y;m++){let p=c.getX(m);Cc.fromBufferAttribute(u,p),xy(Cc,p,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let m=d,y=f;m<y;m++)Cc.fromBufferAttribute(u,m),xy(Cc,m,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function xy(i,e,t,n,s,r,o){let a=Cf.distanceSqToPoint(i);if(a<t){let l=new F;Cf.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var $a=class extends si{constructor(e=[],t=Br,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Os=class extends si{constructor(e,t,n=Hi,s,r,o,a=Fn,l=Fn,c,h=Ds,u=1){if(h!==Ds&&h!==zs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Oo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ya=class extends Os{constructor(e,t=Hi,n=Br,s,r,o=Fn,a=Fn,l,c=Ds){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ja=class extends si{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},cr=class i extends pn{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;m("z","y","x",-1,-1,n,t,e,o,r,0),m("z","y","x",1,-1,n,t,-e,o,r,1),m("x","z","y",1,1,e,n,t,s,o,2),m("x","z","y",1,-1,e,n,-t,s,o,3),m("x","y","z",1,-1,e,t,n,s,r,4),m("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new $t(c,3)),this.setAttribute("normal",new $t(h,3)),this.setAttribute("uv",new $t(u,2));function m(y,p,g,v,M,_,E,T,x,S,O){let L=_/x,R=E/S,U=_/2,z=E/2,I=T/2,G=x+1,q=S+1,H=0,he=0,Y=new F;for(let ee=0;ee<q;ee++){let J=ee*R-z;for(let ae=0;ae<G;ae++){let re=ae*L-U;Y[y]=re*v,Y[p]=J*M,Y[g]=I,c.push(Y.x,Y.y,Y.z),Y[y]=0,Y[p]=0,Y[g]=T>0?1:-1,h.push(Y.x,Y.y,Y.z),u.push(ae/x),u.push(1-ee/S),H+=1}}for(let ee=0;ee<S;ee++)for(let J=0;J<x;J++){let ae=d+J+G*ee,re=d+J+G*(ee+1),Q=d+(J+1)+G*(ee+1),pe=d+(J+1)+G*ee;l.push(ae,re,pe),l.push(re,Q,pe),he+=6}a.addGroup(f,he,O),f+=he,d+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Dr=class i extends pn{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],m=0,y=[],p=n/2,g=0;v(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(h),this.setAttribute("position",new $t(u,3)),this.setAttribute("normal",new $t(d,3)),this.setAttribute("uv",new $t(f,2));function v(){let _=new F,E=new F,T=0,x=(t-e)/n;for(let S=0;S<=r;S++){let O=[],L=S/r,R=L*(t-e)+e;for(let U=0;U<=s;U++){let z=U/s,I=z*l+a,G=Math.sin(I),q=Math.cos(I);E.x=R*G,E.y=-L*n+p,E.z=R*q,u.push(E.x,E.y,E.z),_.set(G,x,q).normalize(),d.push(_.x,_.y,_.z),f.push(z,1-L),O.push(m++)}y.push(O)}for(let S=0;S<s;S++)for(let O=0;O<r;O++){let L=y[O][S],R=y[O+1][S],U=y[O+1][S+1],z=y[O][S+1];(e>0||O!==0)&&(h.push(L,R,z),T+=3),(t>0||O!==r-1)&&(h.push(R,U,z),T+=3)}c.addGroup(g,T,0),g+=T}function M(_){let E=m,T=new Fe,x=new F,S=0,O=_===!0?e:t,L=_===!0?1:-1;for(let U=1;U<=s;U++)u.push(0,p*L,0),d.push(0,L,0),f.push(.5,.5),m++;let R=m;for(let U=0;U<=s;U++){let I=U/s*l+a,G=Math.cos(I),q=Math.sin(I);x.x=O*q,x.y=p*L,x.z=O*G,u.push(x.x,x.y,x.z),d.push(0,L,0),T.x=G*.5+.5,T.y=q*.5*L+.5,f.push(T.x,T.y),m++}for(let U=0;U<s;U++){let z=E+U,I=R+U;_===!0?h.push(I,I+1,z):h.push(I+1,I,z),S+=3}c.addGroup(g,S,_===!0?1:2),g+=S}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Ka=class i extends Dr{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Rc=new F,Pc=new F,_f=new F,Ic=new Ls,Go=class extends pn{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(Bc*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let m=0;m<l;m+=3){o?(c[0]=o.getX(m),c[1]=o.getX(m+1),c[2]=o.getX(m+2)):(c[0]=m,c[1]=m+1,c[2]=m+2);let{a:y,b:p,c:g}=Ic;if(y.fromBufferAttribute(a,c[0]),p.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),Ic.getNormal(_f),u[0]=`${Math.round(y.x*s)},${Math.round(y.y*s)},${Math.round(y.z*s)}`,u[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,u[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let v=0;v<3;v++){let M=(v+1)%3,_=u[v],E=u[M],T=Ic[h[v]],x=Ic[h[M]],S=`${_}_${E}`,O=`${E}_${_}`,L=d.get(O);L?(_f.dot(L.normal)<=r&&(f.push(T.x,T.y,T.z),f.push(x.x,x.y,x.z)),d.set(O,null)):d.has(S)||d.set(S,{index0:c[v],index1:c[M],normal:_f.clone()})}}for(let m of d.values())if(m){let{index0:y,index1:p}=m;Rc.fromBufferAttribute(a,y),Pc.fromBufferAttribute(a,p),f.push(Rc.x,Rc.y,Rc.z),f.push(Pc.x,Pc.y,Pc.z)}this.setAttribute("position",new $t(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}},vi=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){it("Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],d=n[s+1]-h,f=(o-h)/d;return(s+f)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new Fe:new F);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new F,s=[],r=[],o=[],a=new F,l=new Ht;for(let f=0;f<=e;f++){let m=f/e;s[f]=this.getTangentAt(m,new F)}r[0]=new F,o[0]=new F;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),d<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=e;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let m=Math.acos(Tt(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,m))}o[f].crossVectors(s[f],r[f])}if(t===!0){let f=Math.acos(Tt(r[0].dot(r[e]),-1,1));f/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(f=-f);for(let m=1;m<=e;m++)r[m].applyMatrix4(l.makeRotationAxis(s[m],f*m)),o[m].crossVectors(s[m],r[m])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}},Ho=class extends vi{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new Fe){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},sh=class extends Ho{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function hp(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let d=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+u)+(l-a)/u;d*=h,f*=h,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var _y=new F,by=new F,bf=new hp,Mf=new hp,Sf=new hp,rh=class extends vi{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new F){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(by.subVectors(s[0],s[1]).add(s[0]),c=by);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(_y.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=_y),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,m=Math.pow(c.distanceToSquared(u),f),y=Math.pow(u.distanceToSquared(d),f),p=Math.pow(d.distanceToSquared(h),f);y<1e-4&&(y=1),m<1e-4&&(m=y),p<1e-4&&(p=y),bf.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,m,y,p),Mf.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,m,y,p),Sf.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,m,y,p)}else this.curveType==="catmullrom"&&(bf.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),Mf.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),Sf.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return n.set(bf.calc(l),Mf.calc(l),Sf.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new F().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function My(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function zS(i,e){let t=1-i;return t*t*e}function VS(i,e){return 2*(1-i)*i*e}function GS(i,e){return i*i*e}function Ua(i,e,t,n){return zS(i,e)+VS(i,t)+GS(i,n)}function HS(i,e){let t=1-i;return t*t*t*e}function WS(i,e){let t=1-i;return 3*t*t*i*e}function XS(i,e){return 3*(1-i)*i*i*e}function qS(i,e){return i*i*i*e}function Oa(i,e,t,n,s){return HS(i,e)+WS(i,t)+XS(i,n)+qS(i,s)}var Za=class extends vi{constructor(e=new Fe,t=new Fe,n=new Fe,s=new Fe){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new Fe){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Oa(e,s.x,r.x,o.x,a.x),Oa(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},oh=class extends vi{constructor(e=new F,t=new F,n=new F,s=new F){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new F){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Oa(e,s.x,r.x,o.x,a.x),Oa(e,s.y,r.y,o.y,a.y),Oa(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},ja=class extends vi{constructor(e=new Fe,t=new Fe){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new Fe){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new Fe){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},ah=class extends vi{constructor(e=new F,t=new F){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new F){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new F){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Qa=class extends vi{constructor(e=new Fe,t=new Fe,n=new Fe){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new Fe){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(Ua(e,s.x,r.x,o.x),Ua(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},lh=class extends vi{constructor(e=new F,t=new F,n=new F){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new F){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(Ua(e,s.x,r.x,o.x),Ua(e,s.y,r.y,o.y),Ua(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},el=class extends vi{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new Fe){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(My(a,l.x,c.x,h.x,u.x),My(a,l.y,c.y,h.y,u.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new Fe().fromArray(s))}return this}},Rf=Object.freeze({__proto__:null,ArcCurve:sh,CatmullRomCurve3:rh,CubicBezierCurve:Za,CubicBezierCurve3:oh,EllipseCurve:Ho,LineCurve:ja,LineCurve3:ah,QuadraticBezierCurve:Qa,QuadraticBezierCurve3:lh,SplineCurve:el}),ch=class extends vi{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(e){this.curves.push(e)}closePath(){let e=this.curves[0].getPoint(0),t=this.curves[this.curves.length-1].getPoint(1);if(!e.equals(t)){let n=e.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Rf[n](t,e))}return this}getPoint(e,t){let n=e*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,t)}r++}return null}getLength(){let e=this.getCurveLengths();return e[e.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let e=[],t=0;for(let n=0,s=this.curves.length;n<s;n++)t+=this.curves[n].getLength(),e.push(t);return this.cacheLengths=e,e}getSpacedPoints(e=40){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return this.autoClose&&t.push(t[0]),t}getPoints(e=12){let t=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?e*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?e*o.points.length:e,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(t.push(h),n=h)}}return this.autoClose&&t.length>1&&!t[t.length-1].equals(t[0])&&t.push(t[0]),t}copy(e){super.copy(e),this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(s.clone())}return this.autoClose=e.autoClose,this.cacheLengths=null,this}toJSON(){let e=super.toJSON();e.autoClose=this.autoClose,e.curves=[];for(let t=0,n=this.curves.length;t<n;t++){let s=this.curves[t];e.curves.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.autoClose=e.autoClose,this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(new Rf[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},Fr=class extends ch{constructor(e){super(),this.type="Path",this.currentPoint=new Fe,e&&this.setFromPoints(e)}setFromPoints(e){this.moveTo(e[0].x,e[0].y);for(let t=1,n=e.length;t<n;t++)this.lineTo(e[t].x,e[t].y);return this}moveTo(e,t){return this.currentPoint.set(e,t),this}lineTo(e,t){let n=new ja(this.currentPoint.clone(),new Fe(e,t));return this.curves.push(n),this.currentPoint.set(e,t),this}quadraticCurveTo(e,t,n,s){let r=new Qa(this.currentPoint.clone(),new Fe(e,t),new Fe(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(e,t,n,s,r,o){let a=new Za(this.currentPoint.clone(),new Fe(e,t),new Fe(n,s),new Fe(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(e){let t=[this.currentPoint.clone()].concat(e),n=new el(t);return this.curves.push(n),this.currentPoint.copy(e[e.length-1]),this}arc(e,t,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(e+a,t+l,n,s,r,o),this}absarc(e,t,n,s,r,o){return this.absellipse(e,t,n,n,s,r,o),this}ellipse(e,t,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(e+c,t+h,n,s,r,o,a,l),this}absellipse(e,t,n,s,r,o,a,l){let c=new Ho(e,t,n,s,r,o,a,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(e){return super.copy(e),this.currentPoint.copy(e.currentPoint),this}toJSON(){let e=super.toJSON();return e.currentPoint=this.currentPoint.toArray(),e}fromJSON(e){return super.fromJSON(e),this.currentPoint.fromArray(e.currentPoint),this}},Wo=class extends Fr{constructor(e){super(e),this.uuid=Qo(),this.type="Shape",this.holes=[]}getPointsHoles(e){let t=[];for(let n=0,s=this.holes.length;n<s;n++)t[n]=this.holes[n].getPoints(e);return t}extractPoints(e){return{shape:this.getPoints(e),holes:this.getPointsHoles(e)}}copy(e){super.copy(e),this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.uuid=this.uuid,e.holes=[];for(let t=0,n=this.holes.length;t<n;t++){let s=this.holes[t];e.holes.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.uuid=e.uuid,this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(new Fr().fromJSON(s))}return this}};function $S(i,e,t=2){let n=e&&e.length,s=n?e[0]*t:i.length,r=mv(i,0,s,t,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=jS(i,e,r,t)),i.length>80*t){a=i[0],l=i[1];let h=a,u=l;for(let d=t;d<s;d+=t){let f=i[d],m=i[d+1];f<a&&(a=f),m<l&&(l=m),f>h&&(h=f),m>u&&(u=m)}c=Math.max(h-a,u-l),c=c!==0?32767/c:0}return tl(r,o,t,a,l,c,0),o}function mv(i,e,t,n,s){let r;if(s===cw(i,e,t,n)>0)for(let o=e;o<t;o+=n)r=Sy(o/n|0,i[o],i[o+1],r);else for(let o=t-n;o>=e;o-=n)r=Sy(o/n|0,i[o],i[o+1],r);return r&&Xo(r,r.next)&&(il(r),r=r.next),r}function Ur(i,e){if(!i)return i;e||(e=i);let t=i,n;do if(n=!1,!t.steiner&&(Xo(t,t.next)||rn(t.prev,t,t.next)===0)){if(il(t),t=e=t.prev,t===t.next)break;n=!0}else t=t.next;while(n||t!==e);return e}function tl(i,e,t,n,s,r,o){if(!i)return;!o&&r&&iw(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?JS(i,n,s,r):YS(i)){e.push(l.i,i.i,c.i),il(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=KS(Ur(i),e),tl(i,e,t,n,s,r,2)):o===2&&ZS(i,e,t,n,s,r):tl(Ur(i),e,t,n,s,r,1);break}}}function YS(i){let e=i.prev,t=i,n=i.next;if(rn(e,t,n)>=0)return!1;let s=e.x,r=t.x,o=n.x,a=e.y,l=t.y,c=n.y,h=Math.min(s,r,o),u=Math.min(a,l,c),d=Math.max(s,r,o),f=Math.max(a,l,c),m=n.next;for(;m!==e;){if(m.x>=h&&m.x<=d&&m.y>=u&&m.y<=f&&Da(s,a,r,l,o,c,m.x,m.y)&&rn(m.prev,m,m.next)>=0)return!1;m=m.next}return!0}function JS(i,e,t,n){let s=i.prev,r=i,o=i.next;if(rn(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,h=s.y,u=r.y,d=o.y,f=Math.min(a,l,c),m=Math.min(h,u,d),y=Math.max(a,l,c),p=Math.max(h,u,d),g=Pf(f,m,e,t,n),v=Pf(y,p,e,t,n),M=i.prevZ,_=i.nextZ;for(;M&&M.z>=g&&_&&_.z<=v;){if(M.x>=f&&M.x<=y&&M.y>=m&&M.y<=p&&M!==s&&M!==o&&Da(a,h,l,u,c,d,M.x,M.y)&&rn(M.prev,M,M.next)>=0||(M=M.prevZ,_.x>=f&&_.x<=y&&_.y>=m&&_.y<=p&&_!==s&&_!==o&&Da(a,h,l,u,c,d,_.x,_.y)&&rn(_.prev,_,_.next)>=0))return!1;_=_.nextZ}for(;M&&M.z>=g;){if(M.x>=f&&M.x<=y&&M.y>=m&&M.y<=p&&M!==s&&M!==o&&Da(a,h,l,u,c,d,M.x,M.y)&&rn(M.prev,M,M.next)>=0)return!1;M=M.prevZ}for(;_&&_.z<=v;){if(_.x>=f&&_.x<=y&&_.y>=m&&_.y<=p&&_!==s&&_!==o&&Da(a,h,l,u,c,d,_.x,_.y)&&rn(_.prev,_,_.next)>=0)return!1;_=_.nextZ}return!0}function KS(i,e){let t=i;do{let n=t.prev,s=t.next.next;!Xo(n,s)&&yv(n,t,t.next,s)&&nl(n,s)&&nl(s,n)&&(e.push(n.i,t.i,s.i),il(t),il(t.next),t=i=s),t=t.next}while(t!==i);return Ur(t)}function ZS(i,e,t,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&ow(o,a)){let l=vv(o,a);o=Ur(o,o.next),l=Ur(l,l.next),tl(o,e,t,n,s,r,0),tl(l,e,t,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function jS(i,e,t,n){let s=[];for(let r=0,o=e.length;r<o;r++){let a=e[r]*n,l=r<o-1?e[r+1]*n:i.length,c=mv(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(rw(c))}s.sort(QS);for(let r=0;r<s.length;r++)t=ew(s[r],t);return t}function QS(i,e){let t=i.x-e.x;if(t===0&&(t=i.y-e.y,t===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(e.next.y-e.y)/(e.next.x-e.x);t=n-s}return t}function ew(i,e){let t=tw(i,e);if(!t)return e;let n=vv(t,i);return Ur(n,n.next),Ur(t,t.next)}function tw(i,e){let t=e,n=i.x,s=i.y,r=-1/0,o;if(Xo(i,t))return t;do{if(Xo(i,t.next))return t.next;if(s<=t.y&&s>=t.next.y&&t.next.y!==t.y){let u=t.x+(s-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(u<=n&&u>r&&(r=u,o=t.x<t.next.x?t:t.next,u===n))return o}t=t.next}while(t!==e);if(!o)return null;let a=o,l=o.x,c=o.y,h=1/0;t=o;do{if(n>=t.x&&t.x>=l&&n!==t.x&&gv(s<c?n:r,s,l,c,s<c?r:n,s,t.x,t.y)){let u=Math.abs(s-t.y)/(n-t.x);nl(t,i)&&(u<h||u===h&&(t.x>o.x||t.x===o.x&&nw(o,t)))&&(o=t,h=u)}t=t.next}while(t!==a);return o}function nw(i,e){return rn(i.prev,i,e.prev)<0&&rn(e.next,i,i.next)<0}function iw(i,e,t,n){let s=i;do s.z===0&&(s.z=Pf(s.x,s.y,e,t,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,sw(s)}function sw(i){let e,t=1;do{let n=i,s;i=null;let r=null;for(e=0;n;){e++;let o=n,a=0;for(let c=0;c<t&&(a++,o=o.nextZ,!!o);c++);let l=t;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,t*=2}while(e>1);return i}function Pf(i,e,t,n,s){return i=(i-t)*s|0,e=(e-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,i|e<<1}function rw(i){let e=i,t=i;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==i);return t}function gv(i,e,t,n,s,r,o,a){return(s-o)*(e-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(t-o)*(e-a)&&(t-o)*(r-a)>=(s-o)*(n-a)}function Da(i,e,t,n,s,r,o,a){return!(i===o&&e===a)&&gv(i,e,t,n,s,r,o,a)}function ow(i,e){return i.next.i!==e.i&&i.prev.i!==e.i&&!aw(i,e)&&(nl(i,e)&&nl(e,i)&&lw(i,e)&&(rn(i.prev,i,e.prev)||rn(i,e.prev,e))||Xo(i,e)&&rn(i.prev,i,i.next)>0&&rn(e.prev,e,e.next)>0)}function rn(i,e,t){return(e.y-i.y)*(t.x-e.x)-(e.x-i.x)*(t.y-e.y)}function Xo(i,e){return i.x===e.x&&i.y===e.y}function yv(i,e,t,n){let s=Nc(rn(i,e,t)),r=Nc(rn(i,e,n)),o=Nc(rn(t,n,i)),a=Nc(rn(t,n,e));return!!(s!==r&&o!==a||s===0&&Lc(i,t,e)||r===0&&Lc(i,n,e)||o===0&&Lc(t,i,n)||a===0&&Lc(t,e,n))}function Lc(i,e,t){return e.x<=Math.max(i.x,t.x)&&e.x>=Math.min(i.x,t.x)&&e.y<=Math.max(i.y,t.y)&&e.y>=Math.min(i.y,t.y)}function Nc(i){return i>0?1:i<0?-1:0}function aw(i,e){let t=i;do{if(t.i!==i.i&&t.next.i!==i.i&&t.i!==e.i&&t.next.i!==e.i&&yv(t,t.next,i,e))return!0;t=t.next}while(t!==i);return!1}function nl(i,e){return rn(i.prev,i,i.next)<0?rn(i,e,i.next)>=0&&rn(i,i.prev,e)>=0:rn(i,e,i.prev)<0||rn(i,i.next,e)<0}function lw(i,e){let t=i,n=!1,s=(i.x+e.x)/2,r=(i.y+e.y)/2;do t.y>r!=t.next.y>r&&t.next.y!==t.y&&s<(t.next.x-t.x)*(r-t.y)/(t.next.y-t.y)+t.x&&(n=!n),t=t.next;while(t!==i);return n}function vv(i,e){let t=If(i.i,i.x,i.y),n=If(e.i,e.x,e.y),s=i.next,r=e.prev;return i.next=e,e.prev=i,t.next=s,s.prev=t,n.next=t,t.prev=n,r.next=n,n.prev=r,n}function Sy(i,e,t,n){let s=If(i,e,t);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function il(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function If(i,e,t){return{i,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function cw(i,e,t,n){let s=0;for(let r=e,o=t-n;r<t;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var Lf=class{static triangulate(e,t,n=2){return $S(e,t,n)}},Ir=class i{static area(e){let t=e.length,n=0;for(let s=t-1,r=0;r<t;s=r++)n+=e[s].x*e[r].y-e[r].x*e[s].y;return n*.5}static isClockWise(e){return i.area(e)<0}static triangulateShape(e,t){let n=[],s=[],r=[];wy(e),Ey(n,e);let o=e.length;t.forEach(wy);for(let l=0;l<t.length;l++)s.push(o),o+=t[l].length,Ey(n,t[l]);let a=Lf.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function wy(i){let e=i.length;e>2&&i[e-1].equals(i[0])&&i.pop()}function Ey(i,e){for(let t=0;t<e.length;t++)i.push(e[t].x),i.push(e[t].y)}var sl=class i extends pn{constructor(e=new Wo([new Fe(.5,.5),new Fe(-.5,.5),new Fe(-.5,-.5),new Fe(.5,-.5)]),t={}){super(),this.type="ExtrudeGeometry",this.parameters={shapes:e,options:t},e=Array.isArray(e)?e:[e];let n=this,s=[],r=[];for(let a=0,l=e.length;a<l;a++){let c=e[a];o(c)}this.setAttribute("position",new $t(s,3)),this.setAttribute("uv",new $t(r,2)),this.computeVertexNormals();function o(a){let l=[],c=t.curveSegments!==void 0?t.curveSegments:12,h=t.steps!==void 0?t.steps:1,u=t.depth!==void 0?t.depth:1,d=t.bevelEnabled!==void 0?t.bevelEnabled:!0,f=t.bevelThickness!==void 0?t.bevelThickness:.2,m=t.bevelSize!==void 0?t.bevelSize:f-.1,y=t.bevelOffset!==void 0?t.bevelOffset:0,p=t.bevelSegments!==void 0?t.bevelSegments:3,g=t.extrudePath,v=t.UVGenerator!==void 0?t.UVGenerator:hw,M,_=!1,E,T,x,S;if(g){M=g.getSpacedPoints(h),_=!0,d=!1;let le=g.isCatmullRomCurve3?g.closed:!1;E=g.computeFrenetFrames(h,le),T=new F,x=new F,S=new F}d||(p=0,f=0,m=0,y=0);let O=a.extractPoints(c),L=O.shape,R=O.holes;if(!Ir.isClockWise(L)){L=L.reverse();for(let le=0,xe=R.length;le<xe;le++){let ve=R[le];Ir.isClockWise(ve)&&(R[le]=ve.reverse())}}function z(le){let ve=10000000000000001e-36,Be=le[0];for(let Le=1;Le<=le.length;Le++){let st=Le%le.length,ze=le[st],yt=ze.x-Be.x,pt=ze.y-Be.y,xt=yt*yt+pt*pt,B=Math.max(Math.abs(ze.x),Math.abs(ze.y),Math.abs(Be.x),Math.abs(Be.y)),be=ve*B*B;if(xt<=be){le.splice(st,1),Le--;continue}Be=ze}}z(L),R.forEach(z);let I=R.length,G=L;for(let le=0;le<I;le++){let xe=R[le];L=L.concat(xe)}function q(le,xe,ve){return xe||ut("ExtrudeGeometry: vec does not exist"),le.clone().addScaledVector(xe,ve)}let H=L.length;function he(le,xe,ve){let Be,Le,st,ze=le.x-xe.x,yt=le.y-xe.y,pt=ve.x-le.x,xt=ve.y-le.y,B=ze*ze+yt*yt,be=ze*xt-yt*pt;if(Math.abs(be)>Number.EPSILON){let qe=Math.sqrt(B),dt=Math.sqrt(pt*pt+xt*xt),we=xe.x-yt/qe,Ot=xe.y+ze/qe,Je=ve.x-xt/dt,nt=ve.y+pt/dt,P=((Je-we)*xt-(nt-Ot)*pt)/(ze*xt-yt*pt);Be=we+ze*P-le.x,Le=Ot+yt*P-le.y;let w=Be*Be+Le*Le;if(w<=2)return new Fe(Be,Le);st=Math.sqrt(w/2)}else{let qe=!1;ze>Number.EPSILON?pt>Number.EPSILON&&(qe=!0):ze<-Number.EPSILON?pt<-Number.EPSILON&&(qe=!0):Math.sign(yt)===Math.sign(xt)&&(qe=!0),qe?(Be=-yt,Le=ze,st=Math.sqrt(B)):(Be=ze,Le=yt,st=Math.sqrt(B/2))}return new Fe(Be/st,Le/st)}let Y=[];for(let le=0,xe=G.length,ve=xe-1,Be=le+1;le<xe;le++,ve++,Be++)ve===xe&&(ve=0),Be===xe&&(Be=0),Y[le]=he(G[le],G[ve],G[Be]);let ee=[],J,ae=Y.concat();for(let le=0,xe=I;le<xe;le++){let ve=R[le];J=[];for(let Be=0,Le=ve.length,st=Le-1,ze=Be+1;Be<Le;Be++,st++,ze++)st===Le&&(st=0),ze===Le&&(ze=0),J[Be]=he(ve[Be],ve[st],ve[ze]);ee.push(J),ae=ae.concat(J)}let re;if(p===0)re=Ir.triangulateShape(G,R);else{let le=[],xe=[];for(let ve=0;ve<p;ve++){let Be=ve/p,Le=f*Math.cos(Be*Math.PI/2),st=m*Math.sin(Be*Math.PI/2)+y;for(let ze=0,yt=G.length;ze<yt;ze++){let pt=q(G[ze],Y[ze],st);He(pt.x,pt.y,-Le),Be===0&&le.push(pt)}for(let ze=0,yt=I;ze<yt;ze++){let pt=R[ze];J=ee[ze];let xt=[];for(let B=0,be=pt.length;B<be;B++){let qe=q(pt[B],J[B],st);He(qe.x,qe.y,-Le),Be===0&&xt.push(qe)}Be===0&&xe.push(xt)}}re=Ir.triangulateShape(le,xe)}let Q=re.length,pe=m+y;for(let le=0;le<H;le++){let xe=d?q(L[le],ae[le],pe):L[le];_?(x.copy(E.normals[0]).multiplyScalar(xe.x),T.copy(E.binormals[0]).multiplyScalar(xe.y),S.copy(M[0]).add(x).add(T),He(S.x,S.y,S.z)):He(xe.x,xe.y,0)}for(let le=1;le<=h;le++)for(let xe=0;xe<H;xe++){let ve=d?q(L[xe],ae[xe],pe):L[xe];_?(x.copy(E.normals[le]).multiplyScalar(ve.x),T.copy(E.binormals[le]).multiplyScalar(ve.y),S.copy(M[le]).add(x).add(T),He(S.x,S.y,S.z)):He(ve.x,ve.y,u/h*le)}for(let le=p-1;le>=0;le--){let xe=le/p,ve=f*Math.cos(xe*Math.PI/2),Be=m*Math.sin(xe*Math.PI/2)+y;for(let Le=0,st=G.length;Le<st;Le++){let ze=q(G[Le],Y[Le],Be);He(ze.x,ze.y,u+ve)}for(let Le=0,st=R.length;Le<st;Le++){let ze=R[Le];J=ee[Le];for(let yt=0,pt=ze.length;yt<pt;yt++){let xt=q(ze[yt],J[yt],Be);_?He(xt.x,xt.y+M[h-1].y,M[h-1].x+ve):He(xt.x,xt.y,u+ve)}}}ye(),Ae();function ye(){let le=s.length/3;if(d){let xe=0,ve=H*xe;for(let Be=0;Be<Q;Be++){let Le=re[Be];ot(Le[2]+ve,Le[1]+ve,Le[0]+ve)}xe=h+p*2,ve=H*xe;for(let Be=0;Be<Q;Be++){let Le=re[Be];ot(Le[0]+ve,Le[1]+ve,Le[2]+ve)}}else{for(let xe=0;xe<Q;xe++){let ve=re[xe];ot(ve[2],ve[1],ve[0])}for(let xe=0;xe<Q;xe++){let ve=re[xe];ot(ve[0]+H*h,ve[1]+H*h,ve[2]+H*h)}}n.addGroup(le,s.length/3-le,0)}function Ae(){let le=s.length/3,xe=0;Se(G,xe),xe+=G.length;for(let ve=0,Be=R.length;ve<Be;ve++){let Le=R[ve];Se(Le,xe),xe+=Le.length}n.addGroup(le,s.length/3-le,1)}function Se(le,xe){let ve=le.length;for(;--ve>=0;){let Be=ve,Le=ve-1;Le<0&&(Le=le.length-1);for(let st=0,ze=h+p*2;st<ze;st++){let yt=H*st,pt=H*(st+1),xt=xe+Be+yt,B=xe+Le+yt,be=xe+Le+pt,qe=xe+Be+pt;Ze(xt,B,be,qe)}}}function He(le,xe,ve){l.push(le),l.push(xe),l.push(ve)}function ot(le,xe,ve){at(le),at(xe),at(ve);let Be=s.length/3,Le=v.generateTopUV(n,s,Be-3,Be-2,Be-1);rt(Le[0]),rt(Le[1]),rt(Le[2])}function Ze(le,xe,ve,Be){at(le),at(xe),at(Be),at(xe),at(ve),at(Be);let Le=s.length/3,st=v.generateSideWallUV(n,s,Le-6,Le-3,Le-2,Le-1);rt(st[0]),rt(st[1]),rt(st[3]),rt(st[1]),rt(st[2]),rt(st[3])}function at(le){s.push(l[le*3+0]),s.push(l[le*3+1]),s.push(l[le*3+2])}function rt(le){r.push(le.x),r.push(le.y)}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes,n=this.parameters.options;return uw(t,n,e)}static fromJSON(e,t){let n=[];for(let r=0,o=e.shapes.length;r<o;r++){let a=t[e.shapes[r]];n.push(a)}let s=e.options.extrudePath;return s!==void 0&&(e.options.extrudePath=new Rf[s.type]().fromJSON(s)),new i(n,e.options)}},hw={generateTopUV:function(i,e,t,n,s){let r=e[t*3],o=e[t*3+1],a=e[n*3],l=e[n*3+1],c=e[s*3],h=e[s*3+1];return[new Fe(r,o),new Fe(a,l),new Fe(c,h)]},generateSideWallUV:function(i,e,t,n,s,r){let o=e[t*3],a=e[t*3+1],l=e[t*3+2],c=e[n*3],h=e[n*3+1],u=e[n*3+2],d=e[s*3],f=e[s*3+1],m=e[s*3+2],y=e[r*3],p=e[r*3+1],g=e[r*3+2];return Math.abs(a-h)<Math.abs(o-c)?[new Fe(o,1-l),new Fe(c,1-u),new Fe(d,1-m),new Fe(y,1-g)]:[new Fe(a,1-l),new Fe(h,1-u),new Fe(f,1-m),new Fe(p,1-g)]}};function uw(i,e,t){if(t.shapes=[],Array.isArray(i))for(let n=0,s=i.length;n<s;n++){let r=i[n];t.shapes.push(r.uuid)}else t.shapes.push(i.uuid);return t.options=Object.assign({},e),e.extrudePath!==void 0&&(t.options.extrudePath=e.extrudePath.toJSON()),t}var ks=class i extends pn{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],m=[],y=[],p=[];for(let g=0;g<h;g++){let v=g*d-o;for(let M=0;M<c;M++){let _=M*u-r;m.push(_,-v,0),y.push(0,0,1),p.push(M/a),p.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let M=v+c*g,_=v+c*(g+1),E=v+1+c*(g+1),T=v+1+c*g;f.push(M,_,T),f.push(_,E,T)}this.setIndex(f),this.setAttribute("position",new $t(m,3)),this.setAttribute("normal",new $t(y,3)),this.setAttribute("uv",new $t(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Bs=class i extends pn{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new F,d=new F,f=[],m=[],y=[],p=[];for(let g=0;g<=n;g++){let v=[],M=g/n,_=o+M*a,E=e*Math.cos(_),T=Math.sqrt(e*e-E*E),x=0;g===0&&o===0?x=.5/t:g===n&&l===Math.PI&&(x=-.5/t);for(let S=0;S<=t;S++){let O=S/t,L=s+O*r;u.x=-T*Math.cos(L),u.y=E,u.z=T*Math.sin(L),m.push(u.x,u.y,u.z),d.copy(u).normalize(),y.push(d.x,d.y,d.z),p.push(O+x,1-M),v.push(c++)}h.push(v)}for(let g=0;g<n;g++)for(let v=0;v<t;v++){let M=h[g][v+1],_=h[g][v],E=h[g+1][v],T=h[g+1][v+1];(g!==0||o>0)&&f.push(M,_,T),(g!==n-1||l<Math.PI)&&f.push(_,E,T)}this.setIndex(f),this.setAttribute("position",new $t(m,3)),this.setAttribute("normal",new $t(y,3)),this.setAttribute("uv",new $t(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var qo=class i extends pn{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],u=[],d=new F,f=new F,m=new F;for(let y=0;y<=n;y++){let p=o+y/n*a;for(let g=0;g<=s;g++){let v=g/s*r;f.x=(e+t*Math.cos(p))*Math.cos(v),f.y=(e+t*Math.cos(p))*Math.sin(v),f.z=t*Math.sin(p),c.push(f.x,f.y,f.z),d.x=e*Math.cos(v),d.y=e*Math.sin(v),m.subVectors(f,d).normalize(),h.push(m.x,m.y,m.z),u.push(g/s),u.push(y/n)}}for(let y=1;y<=n;y++)for(let p=1;p<=s;p++){let g=(s+1)*y+p-1,v=(s+1)*(y-1)+p-1,M=(s+1)*(y-1)+p,_=(s+1)*y+p;l.push(g,v,_),l.push(v,M,_)}this.setIndex(l),this.setAttribute("position",new $t(c,3)),this.setAttribute("normal",new $t(h,3)),this.setAttribute("uv",new $t(u,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function Vr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Ty(s))s.isRenderTargetTexture?(it("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Ty(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Xn(i){let e={};for(let t=0;t<i.length;t++){let n=Vr(i[t]);for(let s in n)e[s]=n[s]}return e}function Ty(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function dw(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function up(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Rt.workingColorSpace}var xv={clone:Vr,merge:Xn},fw=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,pw=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Bn=class extends Fs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=fw,this.fragmentShader=pw,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Vr(e.uniforms),this.uniformsGroups=dw(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Pt().setHex(s.value);break;case"v2":this.uniforms[n].value=new Fe().fromArray(s.value);break;case"v3":this.uniforms[n].value=new F().fromArray(s.value);break;case"v4":this.uniforms[n].value=new on().fromArray(s.value);break;case"m3":this.uniforms[n].value=new mt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ht().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},hh=class extends Bn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var uh=class extends Fs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=tv,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},dh=class extends Fs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ro(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Dc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var hr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},fh=class extends hr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ef,endingEnd:Ef}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Tf:r=e,a=2*t-n;break;case Af:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Tf:o=e,l=2*n-t;break;case Af:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,m=(n-t)/(s-t),y=m*m,p=y*m,g=-d*p+2*d*y-d*m,v=(1+d)*p+(-1.5-2*d)*y+(-.5+d)*m+1,M=(-1-f)*p+(1.5+f)*y+.5*m,_=f*p-f*y;for(let E=0;E!==a;++E)r[E]=g*o[h+E]+v*o[c+E]+M*o[l+E]+_*o[u+E];return r}},ph=class extends hr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},mh=class extends hr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},gh=class extends hr{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let m=(n-t)/(s-t),y=1-m;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*m;return r}let d=a*2,f=e-1;for(let m=0;m!==a;++m){let y=o[c+m],p=o[l+m],g=f*d+m*2,v=u[g],M=u[g+1],_=e*d+m*2,E=h[_],T=h[_+1],x=gw(n,t,v,E,s);r[m]=_v(x,y,M,T,p)}return r}};function _v(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function mw(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function gw(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=_v(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=mw(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var xi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ro(t,this.TimeBufferType),this.values=Ro(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ro(e.times,Array),values:Ro(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Dc(e.settings)&&(n.settings={inTangents:Ro(e.settings.inTangents,Array),outTangents:Ro(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new mh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new ph(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new fh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new gh(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ka:t=this.InterpolantFactoryMethodDiscrete;break;case $c:t=this.InterpolantFactoryMethodLinear;break;case Oc:t=this.InterpolantFactoryMethodSmooth;break;case wf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return it("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ka;case this.InterpolantFactoryMethodLinear:return $c;case this.InterpolantFactoryMethodSmooth:return Oc;case this.InterpolantFactoryMethodBezier:return wf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Dc(this.settings)&&(Ay(this.settings.inTangents,e),Ay(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Dc(this.settings)&&(Cy(this.settings.inTangents,e),Cy(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(ut("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ut("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ut("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){ut("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&vS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ut("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Oc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let m=0;m!==n;++m){let y=t[u+m];if(y!==t[d+m]||y!==t[f+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Dc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Ay(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Cy(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}xi.prototype.ValueTypeName="";xi.prototype.TimeBufferType=Float32Array;xi.prototype.ValueBufferType=Float32Array;xi.prototype.DefaultInterpolation=$c;var ur=class extends xi{constructor(e,t,n){super(e,t,n)}};ur.prototype.ValueTypeName="bool";ur.prototype.ValueBufferType=Array;ur.prototype.DefaultInterpolation=ka;ur.prototype.InterpolantFactoryMethodLinear=void 0;ur.prototype.InterpolantFactoryMethodSmooth=void 0;var yh=class extends xi{constructor(e,t,n,s){super(e,t,n,s)}};yh.prototype.ValueTypeName="color";var vh=class extends xi{constructor(e,t,n,s){super(e,t,n,s)}};vh.prototype.ValueTypeName="number";var xh=class extends hr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)fn.slerpFlat(r,0,o,c-a,o,c,l);return r}},rl=class extends xi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new xh(this.times,this.values,this.getValueSize(),e)}};rl.prototype.ValueTypeName="quaternion";rl.prototype.InterpolantFactoryMethodSmooth=void 0;var dr=class extends xi{constructor(e,t,n){super(e,t,n)}};dr.prototype.ValueTypeName="string";dr.prototype.ValueBufferType=Array;dr.prototype.DefaultInterpolation=ka;dr.prototype.InterpolantFactoryMethodLinear=void 0;dr.prototype.InterpolantFactoryMethodSmooth=void 0;var _h=class extends xi{constructor(e,t,n,s){super(e,t,n,s)}};_h.prototype.ValueTypeName="vector";var bh=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],m=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},bv=new bh,Mh=class{constructor(e){this.manager=e!==void 0?e:bv,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Mh.DEFAULT_MATERIAL_NAME="__DEFAULT";var Fc=new F,Uc=new fn,hs=new F,ol=class extends ri{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ht,this.projectionMatrix=new Ht,this.projectionMatrixInverse=new Ht,this.coordinateSystem=Pi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Fc,Uc,hs),hs.x===1&&hs.y===1&&hs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fc,Uc,hs.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Fc,Uc,hs),hs.x===1&&hs.y===1&&hs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fc,Uc,hs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},or=new F,Ry=new Fe,Py=new Fe,Qn=class extends ol{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Yc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Bc*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Yc*2*Math.atan(Math.tan(Bc*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){or.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(or.x,or.y).multiplyScalar(-e/or.z),or.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(or.x,or.y).multiplyScalar(-e/or.z)}getViewSize(e,t){return this.getViewBounds(e,Ry,Py),t.subVectors(Py,Ry)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Bc*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var $o=class extends ol{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Po=-90,Io=1,Yo=class extends ri{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Qn(Po,Io,e,t);s.layers=this.layers,this.add(s);let r=new Qn(Po,Io,e,t);r.layers=this.layers,this.add(r);let o=new Qn(Po,Io,e,t);o.layers=this.layers,this.add(o);let a=new Qn(Po,Io,e,t);a.layers=this.layers,this.add(a);let l=new Qn(Po,Io,e,t);l.layers=this.layers,this.add(l);let c=new Qn(Po,Io,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Pi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Va)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},Sh=class extends Qn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var dp="\\[\\]\\.:\\/",yw=new RegExp("["+dp+"]","g"),fp="[^"+dp+"]",vw="[^"+dp.replace("\\.","")+"]",xw=/((?:WC+[\/:])*)/.source.replace("WC",fp),_w=/(WCOD+)?/.source.replace("WCOD",vw),bw=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",fp),Mw=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",fp),Sw=new RegExp("^"+xw+_w+bw+Mw+"$"),ww=["material","materials","bones","map"],Nf=class{constructor(e,t,n){let s=n||Qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Qt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(yw,"")}static parseTrackName(e){let t=Sw.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);ww.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){it("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){ut("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){ut("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){ut("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){ut("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){ut("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){ut("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){ut("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;ut("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){ut("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){ut("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Qt.Composite=Nf;Qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Qt.prototype.GetterByBindingType=[Qt.prototype._getValue_direct,Qt.prototype._getValue_array,Qt.prototype._getValue_arrayElement,Qt.prototype._getValue_toArray];Qt.prototype.SetterByBindingTypeAndVersioning=[[Qt.prototype._setValue_direct,Qt.prototype._setValue_direct_setNeedsUpdate,Qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Qt.prototype._setValue_array,Qt.prototype._setValue_array_setNeedsUpdate,Qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Qt.prototype._setValue_arrayElement,Qt.prototype._setValue_arrayElement_setNeedsUpdate,Qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Qt.prototype._setValue_fromArray,Qt.prototype._setValue_fromArray_setNeedsUpdate,Qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var v3=new Float32Array(1);var Df=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};function pp(i,e,t,n){let s=Ew(n);switch(t){case ep:return i*e;case np:return i*e/s.components*s.byteLength;case Ph:return i*e/s.components*s.byteLength;case pr:return i*e*2/s.components*s.byteLength;case Ih:return i*e*2/s.components*s.byteLength;case tp:return i*e*3/s.components*s.byteLength;case bi:return i*e*4/s.components*s.byteLength;case Lh:return i*e*4/s.components*s.byteLength;case cl:case hl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case ul:case dl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Dh:case Uh:return Math.max(i,16)*Math.max(e,8)/4;case Nh:case Fh:return Math.max(i,8)*Math.max(e,8)/2;case Oh:case kh:case zh:case Vh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Bh:case fl:case Gh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Hh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Wh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Xh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case qh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case $h:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Yh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Jh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Kh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Zh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case jh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Qh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case eu:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case tu:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case nu:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case iu:case su:case ru:return Math.ceil(i/4)*Math.ceil(e/4)*16;case ou:case au:return Math.ceil(i/4)*Math.ceil(e/4)*8;case pl:case lu:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Ew(i){switch(i){case ii:case Kf:return{byteLength:1,components:1};case jo:case Zf:case Xi:return{byteLength:2,components:1};case Ch:case Rh:return{byteLength:2,components:4};case Hi:case Ah:case Wi:return{byteLength:4,components:1};case jf:case Qf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?it("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Hv(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function Aw(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,m)=>f.start-m.start);let d=0;for(let f=1;f<u.length;f++){let m=u[d],y=u[f];y.start<=m.start+m.count+1?m.count=Math.max(m.count,y.start+y.count-m.start):(++d,u[d]=y)}u.length=d+1;for(let f=0,m=u.length;f<m;f++){let y=u[f];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Cw=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Rw=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Pw=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Iw=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Lw=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Nw=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Dw=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Fw=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Uw=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Ow=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,kw=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Bw=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,zw=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Vw=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Gw=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Hw=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Ww=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Xw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,qw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,$w=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Yw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Jw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Kw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Zw=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,jw=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Qw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,e1=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,t1=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,n1=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,i1="gl_FragColor = linearToOutputTexel( gl_FragColor );",s1=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,r1=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,o1=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,a1=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,l1=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,c1=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,h1=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,u1=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,d1=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,f1=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,p1=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,m1=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,g1=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,y1=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,v1=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,x1=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,_1=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,b1=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,M1=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,S1=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,w1=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,E1=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,T1=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,A1=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,C1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,R1=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,P1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,I1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,L1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,N1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,D1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,F1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,U1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,O1=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,k1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,B1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,z1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,V1=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,G1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,H1=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,W1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,X1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,q1=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,$1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Y1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,J1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,K1=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Z1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,j1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Q1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,eE=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,tE=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,nE=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,iE=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,sE=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,rE=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,oE=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,aE=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,lE=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,cE=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,hE=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,uE=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,dE=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,fE=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,pE=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,mE=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,gE=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,yE=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,vE=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,xE=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,_E=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,bE=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,ME=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,SE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,wE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,EE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,TE=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,AE=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,CE=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,RE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,PE=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,IE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,LE=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,NE=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,DE=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,FE=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,UE=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,OE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,kE=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,BE=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,zE=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,VE=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,GE=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,HE=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,WE=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,XE=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,qE=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$E=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,YE=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,JE=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,KE=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ZE=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,jE=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,QE=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,eT=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,tT=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,nT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,iT=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,sT=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,rT=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,oT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,bt={alphahash_fragment:Cw,alphahash_pars_fragment:Rw,alphamap_fragment:Pw,alphamap_pars_fragment:Iw,alphatest_fragment:Lw,alphatest_pars_fragment:Nw,aomap_fragment:Dw,aomap_pars_fragment:Fw,batching_pars_vertex:Uw,batching_vertex:Ow,begin_vertex:kw,beginnormal_vertex:Bw,bsdfs:zw,iridescence_fragment:Vw,bumpmap_pars_fragment:Gw,clipping_planes_fragment:Hw,clipping_planes_pars_fragment:Ww,clipping_planes_pars_vertex:Xw,clipping_planes_vertex:qw,color_fragment:$w,color_pars_fragment:Yw,color_pars_vertex:Jw,color_vertex:Kw,common:Zw,defaultnormal_vertex:jw,displacementmap_pars_vertex:Qw,displacementmap_vertex:e1,emissivemap_fragment:t1,emissivemap_pars_fragment:n1,colorspace_fragment:i1,colorspace_pars_fragment:s1,envmap_fragment:r1,envmap_common_pars_fragment:o1,envmap_pars_fragment:a1,envmap_pars_vertex:l1,envmap_physical_pars_fragment:x1,envmap_vertex:c1,fog_vertex:h1,fog_pars_vertex:u1,fog_fragment:d1,fog_pars_fragment:f1,gradientmap_pars_fragment:p1,lightmap_pars_fragment:m1,lights_lambert_fragment:g1,lights_lambert_pars_fragment:y1,lights_pars_begin:v1,lights_toon_fragment:_1,lights_toon_pars_fragment:b1,lights_phong_fragment:M1,lights_phong_pars_fragment:S1,lights_physical_fragment:w1,lights_physical_pars_fragment:E1,lights_fragment_begin:T1,lights_fragment_maps:A1,lights_fragment_end:C1,lightprobes_pars_fragment:R1,logdepthbuf_fragment:P1,logdepthbuf_pars_fragment:I1,logdepthbuf_pars_vertex:L1,logdepthbuf_vertex:N1,map_fragment:D1,map_pars_fragment:F1,map_particle_fragment:U1,map_particle_pars_fragment:O1,metalnessmap_fragment:k1,metalnessmap_pars_fragment:B1,morphinstance_vertex:z1,morphcolor_vertex:V1,morphnormal_vertex:G1,morphtarget_pars_vertex:H1,morphtarget_vertex:W1,normal_fragment_begin:X1,normal_fragment_maps:q1,normal_pars_fragment:$1,normal_pars_vertex:Y1,normal_vertex:J1,normalmap_pars_fragment:K1,clearcoat_normal_fragment_begin:Z1,clearcoat_normal_fragment_maps:j1,clearcoat_pars_fragment:Q1,iridescence_pars_fragment:eE,opaque_fragment:tE,packing:nE,premultiplied_alpha_fragment:iE,project_vertex:sE,dithering_fragment:rE,dithering_pars_fragment:oE,roughnessmap_fragment:aE,roughnessmap_pars_fragment:lE,shadowmap_pars_fragment:cE,shadowmap_pars_vertex:hE,shadowmap_vertex:uE,shadowmask_pars_fragment:dE,skinbase_vertex:fE,skinning_pars_vertex:pE,skinning_vertex:mE,skinnormal_vertex:gE,specularmap_fragment:yE,specularmap_pars_fragment:vE,tonemapping_fragment:xE,tonemapping_pars_fragment:_E,transmission_fragment:bE,transmission_pars_fragment:ME,uv_pars_fragment:SE,uv_pars_vertex:wE,uv_vertex:EE,worldpos_vertex:TE,background_vert:AE,background_frag:CE,backgroundCube_vert:RE,backgroundCube_frag:PE,cube_vert:IE,cube_frag:LE,depth_vert:NE,depth_frag:DE,distance_vert:FE,distance_frag:UE,equirect_vert:OE,equirect_frag:kE,linedashed_vert:BE,linedashed_frag:zE,meshbasic_vert:VE,meshbasic_frag:GE,meshlambert_vert:HE,meshlambert_frag:WE,meshmatcap_vert:XE,meshmatcap_frag:qE,meshnormal_vert:$E,meshnormal_frag:YE,meshphong_vert:JE,meshphong_frag:KE,meshphysical_vert:ZE,meshphysical_frag:jE,meshtoon_vert:QE,meshtoon_frag:eT,points_vert:tT,points_frag:nT,shadow_vert:iT,shadow_frag:sT,sprite_vert:rT,sprite_frag:oT},ke={common:{diffuse:{value:new Pt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new mt},alphaMap:{value:null},alphaMapTransform:{value:new mt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new mt}},envmap:{envMap:{value:null},envMapRotation:{value:new mt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new mt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new mt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new mt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new mt},normalScale:{value:new Fe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new mt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new mt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new mt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new mt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Pt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Pt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new mt},alphaTest:{value:0},uvTransform:{value:new mt}},sprite:{diffuse:{value:new Pt(16777215)},opacity:{value:1},center:{value:new Fe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new mt},alphaMap:{value:null},alphaMapTransform:{value:new mt},alphaTest:{value:0}}},vs={basic:{uniforms:Xn([ke.common,ke.specularmap,ke.envmap,ke.aomap,ke.lightmap,ke.fog]),vertexShader:bt.meshbasic_vert,fragmentShader:bt.meshbasic_frag},lambert:{uniforms:Xn([ke.common,ke.specularmap,ke.envmap,ke.aomap,ke.lightmap,ke.emissivemap,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.fog,ke.lights,{emissive:{value:new Pt(0)},envMapIntensity:{value:1}}]),vertexShader:bt.meshlambert_vert,fragmentShader:bt.meshlambert_frag},phong:{uniforms:Xn([ke.common,ke.specularmap,ke.envmap,ke.aomap,ke.lightmap,ke.emissivemap,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.fog,ke.lights,{emissive:{value:new Pt(0)},specular:{value:new Pt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:bt.meshphong_vert,fragmentShader:bt.meshphong_frag},standard:{uniforms:Xn([ke.common,ke.envmap,ke.aomap,ke.lightmap,ke.emissivemap,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.roughnessmap,ke.metalnessmap,ke.fog,ke.lights,{emissive:{value:new Pt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:bt.meshphysical_vert,fragmentShader:bt.meshphysical_frag},toon:{uniforms:Xn([ke.common,ke.aomap,ke.lightmap,ke.emissivemap,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.gradientmap,ke.fog,ke.lights,{emissive:{value:new Pt(0)}}]),vertexShader:bt.meshtoon_vert,fragmentShader:bt.meshtoon_frag},matcap:{uniforms:Xn([ke.common,ke.bumpmap,ke.normalmap,ke.displacementmap,ke.fog,{matcap:{value:null}}]),vertexShader:bt.meshmatcap_vert,fragmentShader:bt.meshmatcap_frag},points:{uniforms:Xn([ke.points,ke.fog]),vertexShader:bt.points_vert,fragmentShader:bt.points_frag},dashed:{uniforms:Xn([ke.common,ke.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:bt.linedashed_vert,fragmentShader:bt.linedashed_frag},depth:{uniforms:Xn([ke.common,ke.displacementmap]),vertexShader:bt.depth_vert,fragmentShader:bt.depth_frag},normal:{uniforms:Xn([ke.common,ke.bumpmap,ke.normalmap,ke.displacementmap,{opacity:{value:1}}]),vertexShader:bt.meshnormal_vert,fragmentShader:bt.meshnormal_frag},sprite:{uniforms:Xn([ke.sprite,ke.fog]),vertexShader:bt.sprite_vert,fragmentShader:bt.sprite_frag},background:{uniforms:{uvTransform:{value:new mt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:bt.background_vert,fragmentShader:bt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new mt}},vertexShader:bt.backgroundCube_vert,fragmentShader:bt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:bt.cube_vert,fragmentShader:bt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:bt.equirect_vert,fragmentShader:bt.equirect_frag},distance:{uniforms:Xn([ke.common,ke.displacementmap,{referencePosition:{value:new F},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:bt.distance_vert,fragmentShader:bt.distance_frag},shadow:{uniforms:Xn([ke.lights,ke.fog,{color:{value:new Pt(0)},opacity:{value:1}}]),vertexShader:bt.shadow_vert,fragmentShader:bt.shadow_frag}};vs.physical={uniforms:Xn([vs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new mt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new mt},clearcoatNormalScale:{value:new Fe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new mt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new mt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new mt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new mt},sheen:{value:0},sheenColor:{value:new Pt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new mt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new mt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new mt},transmissionSamplerSize:{value:new Fe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new mt},attenuationDistance:{value:0},attenuationColor:{value:new Pt(0)},specularColor:{value:new Pt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new mt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new mt},anisotropyVector:{value:new Fe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new mt}}]),vertexShader:bt.meshphysical_vert,fragmentShader:bt.meshphysical_frag};var hu={r:0,b:0,g:0},aT=new Ht,Wv=new mt;Wv.set(-1,0,0,0,1,0,0,0,1);function lT(i,e,t,n,s,r){let o=new Pt(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(v){let M=v.isScene===!0?v.background:null;if(M&&M.isTexture){let _=v.backgroundBlurriness>0;M=e.get(M,_)}return M}function m(v){let M=!1,_=f(v);_===null?p(o,a):_&&_.isColor&&(p(_,1),M=!0);let E=i.xr.getEnvironmentBlendMode();E==="additive"?t.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(v,M){let _=f(M);_&&_.isCubeTexture?(c===void 0&&(c=new en(new cr(1,1,1),new Bn({name:"BackgroundCubeMaterial",uniforms:Vr(vs.backgroundCube.uniforms),vertexShader:vs.backgroundCube.vertexShader,fragmentShader:vs.backgroundCube.fragmentShader,side:ni,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,T,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=_,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(aT.makeRotationFromEuler(M.backgroundRotation)).transpose(),_.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Wv),c.material.toneMapped=Rt.getTransfer(_.colorSpace)!==Bt,(h!==_||u!==_.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=_,u=_.version,d=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):_&&_.isTexture&&(l===void 0&&(l=new en(new ks(2,2),new Bn({name:"BackgroundMaterial",uniforms:Vr(vs.background.uniforms),vertexShader:vs.background.vertexShader,fragmentShader:vs.background.fragmentShader,side:fr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=_,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=Rt.getTransfer(_.colorSpace)!==Bt,_.matrixAutoUpdate===!0&&_.updateMatrix(),l.material.uniforms.uvTransform.value.copy(_.matrix),(h!==_||u!==_.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=_,u=_.version,d=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function p(v,M){v.getRGB(hu,up(i)),t.buffers.color.setClear(hu.r,hu.g,hu.b,M,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,M=1){o.set(v),a=M,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,p(o,a)},render:m,addToRenderList:y,dispose:g}}function cT(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(R,U,z,I,G){let q=!1,H=u(R,I,z,U);r!==H&&(r=H,c(r.object)),q=f(R,I,z,G),q&&m(R,I,z,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,_(R,U,z,I),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return i.createVertexArray()}function c(R){return i.bindVertexArray(R)}function h(R){return i.deleteVertexArray(R)}function u(R,U,z,I){let G=I.wireframe===!0,q=n[U.id];q===void 0&&(q={},n[U.id]=q);let H=R.isInstancedMesh===!0?R.id:0,he=q[H];he===void 0&&(he={},q[H]=he);let Y=he[z.id];Y===void 0&&(Y={},he[z.id]=Y);let ee=Y[G];return ee===void 0&&(ee=d(l()),Y[G]=ee),ee}function d(R){let U=[],z=[],I=[];for(let G=0;G<t;G++)U[G]=0,z[G]=0,I[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:z,attributeDivisors:I,object:R,attributes:{},index:null}}function f(R,U,z,I){let G=r.attributes,q=U.attributes,H=0,he=z.getAttributes();for(let Y in he)if(he[Y].location>=0){let J=G[Y],ae=q[Y];if(ae===void 0&&(Y==="instanceMatrix"&&R.instanceMatrix&&(ae=R.instanceMatrix),Y==="instanceColor"&&R.instanceColor&&(ae=R.instanceColor)),J===void 0||J.attribute!==ae||ae&&J.data!==ae.data)return!0;H++}return r.attributesNum!==H||r.index!==I}function m(R,U,z,I){let G={},q=U.attributes,H=0,he=z.getAttributes();for(let Y in he)if(he[Y].location>=0){let J=q[Y];J===void 0&&(Y==="instanceMatrix"&&R.instanceMatrix&&(J=R.instanceMatrix),Y==="instanceColor"&&R.instanceColor&&(J=R.instanceColor));let ae={};ae.attribute=J,J&&J.data&&(ae.data=J.data),G[Y]=ae,H++}r.attributes=G,r.attributesNum=H,r.index=I}function y(){let R=r.newAttributes;for(let U=0,z=R.length;U<z;U++)R[U]=0}function p(R){g(R,0)}function g(R,U){let z=r.newAttributes,I=r.enabledAttributes,G=r.attributeDivisors;z[R]=1,I[R]===0&&(i.enableVertexAttribArray(R),I[R]=1),G[R]!==U&&(i.vertexAttribDivisor(R,U),G[R]=U)}function v(){let R=r.newAttributes,U=r.enabledAttributes;for(let z=0,I=U.length;z<I;z++)U[z]!==R[z]&&(i.disableVertexAttribArray(z),U[z]=0)}function M(R,U,z,I,G,q,H){H===!0?i.vertexAttribIPointer(R,U,z,G,q):i.vertexAttribPointer(R,U,z,I,G,q)}function _(R,U,z,I){y();let G=I.attributes,q=z.getAttributes(),H=U.defaultAttributeValues;for(let he in q){let Y=q[he];if(Y.location>=0){let ee=G[he];if(ee===void 0&&(he==="instanceMatrix"&&R.instanceMatrix&&(ee=R.instanceMatrix),he==="instanceColor"&&R.instanceColor&&(ee=R.instanceColor)),ee!==void 0){let J=ee.normalized,ae=ee.itemSize,re=e.get(ee);if(re===void 0)continue;let Q=re.buffer,pe=re.type,ye=re.bytesPerElement,Ae=pe===i.INT||pe===i.UNSIGNED_INT||ee.gpuType===Ah;if(ee.isInterleavedBufferAttribute){let Se=ee.data,He=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,ot=ee.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let Ze=0;Ze<Y.locationSize;Ze++)g(Y.location+Ze,Se.meshPerAttribute);R.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let Ze=0;Ze<Y.locationSize;Ze++)p(Y.location+Ze);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let Ze=0;Ze<Y.locationSize;Ze++)M(Y.location+Ze,ae/Y.locationSize,pe,J,He*ye,(ot+ae/Y.locationSize*Ze)*ye,Ae)}else{if(ee.isInstancedBufferAttribute){for(let Se=0;Se<Y.locationSize;Se++)g(Y.location+Se,ee.meshPerAttribute);R.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let Se=0;Se<Y.locationSize;Se++)p(Y.location+Se);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let Se=0;Se<Y.locationSize;Se++)M(Y.location+Se,ae/Y.locationSize,pe,J,ae*ye,ae/Y.locationSize*Se*ye,Ae)}}else if(H!==void 0){let J=H[he];if(J!==void 0)switch(J.length){case 2:i.vertexAttrib2fv(Y.location,J);break;case 3:i.vertexAttrib3fv(Y.location,J);break;case 4:i.vertexAttrib4fv(Y.location,J);break;default:i.vertexAttrib1fv(Y.location,J)}}}}v()}function E(){O();for(let R in n){let U=n[R];for(let z in U){let I=U[z];for(let G in I){let q=I[G];for(let H in q)h(q[H].object),delete q[H];delete I[G]}}delete n[R]}}function T(R){if(n[R.id]===void 0)return;let U=n[R.id];for(let z in U){let I=U[z];for(let G in I){let q=I[G];for(let H in q)h(q[H].object),delete q[H];delete I[G]}}delete n[R.id]}function x(R){for(let U in n){let z=n[U];for(let I in z){let G=z[I];if(G[R.id]===void 0)continue;let q=G[R.id];for(let H in q)h(q[H].object),delete q[H];delete G[R.id]}}}function S(R){for(let U in n){let z=n[U],I=R.isInstancedMesh===!0?R.id:0,G=z[I];if(G!==void 0){for(let q in G){let H=G[q];for(let he in H)h(H[he].object),delete H[he];delete G[q]}delete z[I],Object.keys(z).length===0&&delete n[U]}}}function O(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:O,resetDefaultState:L,dispose:E,releaseStatesOfGeometry:T,releaseStatesOfObject:S,releaseStatesOfProgram:x,initAttributes:y,enableAttribute:p,disableUnusedAttributes:v}}function hT(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function uT(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==bi&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let S=x===Xi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==ii&&x!==Wi&&!S&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(it("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&it("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&it("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),_=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),E=i.getParameter(i.MAX_SAMPLES),T=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:m,maxTextureSize:y,maxCubemapSize:p,maxAttributes:g,maxVertexUniforms:v,maxVaryings:M,maxFragmentUniforms:_,maxSamples:E,samples:T}}function dT(i){let e=this,t=null,n=0,s=!1,r=!1,o=new yi,a=new mt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let m=u.clippingPlanes,y=u.clipIntersection,p=u.clipShadows,g=i.get(u);if(!s||m===null||m.length===0||r&&!p)r?h(null):c();else{let v=r?0:n,M=v*4,_=g.clippingState||null;l.value=_,_=h(m,d,M,f);for(let E=0;E!==M;++E)_[E]=t[E];g.clippingState=_,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,m){let y=u!==null?u.length:0,p=null;if(y!==0){if(p=l.value,m!==!0||p===null){let g=f+y*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(p===null||p.length<g)&&(p=new Float32Array(g));for(let M=0,_=f;M!==y;++M,_+=4)o.copy(u[M]).applyMatrix4(v,a),o.normal.toArray(p,_),p[_+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,p}}var vl=class extends ti{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new $a(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new cr(5,5,5),r=new Bn({name:"CubemapFromEquirect",uniforms:Vr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ni,blending:Or});r.uniforms.tEquirect.value=t;let o=new en(s,r),a=t.minFilter;return t.minFilter===_i&&(t.minFilter=An),new Yo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Mv=256,fT=3,pT=20,Xv=256,qv=16,mT=3,gT=new F,yT=new Pt,du=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Yo(1,10,null),this._boxMesh=new en(new cr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=gT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(yT));let p=new Yo(n,s,h);return p.position.copy(a),p.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=m,e.background=y,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ev(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=wv(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Mv,fv(e))}_fromTexture(e,t){e.mapping===Br||e.mapping===Zo?this._setSize(e.image.length===0?Mv:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Sv(e,!1,!1),n=Math.log2(e)-fT;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Sv(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Br||e.mapping===Zo?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ev()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=wv()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=vT(),this._integrationMaterial=xT());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/qv);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-mT)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Xv*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=_T());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function Sv(i,e,t){return new vl(i,{minFilter:_i,generateMipmaps:e,type:Xi,colorSpace:Ba,depthBuffer:t})}function xl(i,e,t){return new Bn({name:i,uniforms:e,vertexShader:bt.cube_vert,fragmentShader:t,side:ni,blending:Or,depthTest:!1,depthWrite:!1})}function vT(){return xl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Xv}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function xT(){return xl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:qv}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function _T(){return xl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${pT}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function wv(){return xl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Ev(){return xl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function bT(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===wh||f===Eh)if(e.has(d)){let m=e.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let y=new vl(m.height);return y.fromEquirectangularTexture(i,d),e.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,m=f===wh||f===Eh,y=f===Br||f===Zo;if(m||y){let p=t.get(d),g=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return n===null&&(n=new du(i)),p=m?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),p.texture;if(p!==void 0)return p.texture;{let v=d.image;return m&&v&&v.height>0||y&&v&&l(v)?(n===null&&(n=new du(i)),p=m?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function a(d,f){return f===wh?d.mapping=Br:f===Eh&&(d.mapping=Zo),d}function l(d){let f=0,m=6;for(let y=0;y<m;y++)d[y]!==void 0&&f++;return f===m}function c(d){let f=d.target;f.removeEventListener("dispose",c);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function MT(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Fa("WebGLRenderer: "+n+" extension not supported."),s}}}function ST(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let p in m.attributes)e.remove(m.attributes[p]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let y=r.get(m);y&&(e.remove(y),r.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function h(m){let y=m.attributes;for(let p in y)e.update(y[p],i.ARRAY_BUFFER)}function u(m){let y=m.index,p=m.attributes.position,g=0;if(p===void 0)return;let v=y!==null?y.array.length:p.array.length/3-1,M=p.count>=65535?qa:Xa,_=new M(Math.ceil(v/3)*6,1),E=_.array;if(y!==null){let x=y.array;g=y.version;for(let S=0,O=0;S<v;S+=3){let L=x[S+0],R=x[S+1],U=x[S+2];E[O++]=L,E[O++]=R,E[O++]=R,E[O++]=U,E[O++]=U,E[O++]=L}}else{g=p.version;for(let x=0,S=0;x<v;x+=3){let O=x+0,L=x+1,R=x+2;E[S++]=O,E[S++]=L,E[S++]=L,E[S++]=R,E[S++]=R,E[S++]=O}}_.version=g;let T=r.get(m);T&&e.remove(T),r.set(m,_)}function d(m){let y=r.get(m);if(y){let p=m.index;p!==null&&y.version<p.version&&u(m)}else u(m);return r.get(m)}function f(){for(let m in s){let y=s[m].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function wT(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let y=0;for(let p=0;p<f;p++)y+=d[p];t.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function ET(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:ut("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function TT(i,e,t){let n=new WeakMap,s=new on;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let O=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",O)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],M=0;f===!0&&(M=1),m===!0&&(M=2),y===!0&&(M=3);let _=a.attributes.position.count*M,E=1;_>e.maxTextureSize&&(E=Math.ceil(_/e.maxTextureSize),_=e.maxTextureSize);let T=new Float32Array(_*E*4*u),x=new Ha(T,_,E,u);x.type=Wi,x.needsUpdate=!0;let S=M*4;for(let L=0;L<u;L++){let R=p[L],U=g[L],z=v[L],I=_*E*4*L;for(let G=0;G<R.count;G++){let q=G*S;f===!0&&(s.fromBufferAttribute(R,G),T[I+q+0]=s.x,T[I+q+1]=s.y,T[I+q+2]=s.z,T[I+q+3]=0),m===!0&&(s.fromBufferAttribute(U,G),T[I+q+4]=s.x,T[I+q+5]=s.y,T[I+q+6]=s.z,T[I+q+7]=0),y===!0&&(s.fromBufferAttribute(z,G),T[I+q+8]=s.x,T[I+q+9]=s.y,T[I+q+10]=s.z,T[I+q+11]=z.itemSize===4?s.w:1)}}d={count:u,texture:x,size:new Fe(_,E)},n.set(a,d),a.addEventListener("dispose",O)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function AT(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var CT={[Gf]:"LINEAR_TONE_MAPPING",[Hf]:"REINHARD_TONE_MAPPING",[Wf]:"CINEON_TONE_MAPPING",[Xf]:"ACES_FILMIC_TONE_MAPPING",[$f]:"AGX_TONE_MAPPING",[Yf]:"NEUTRAL_TONE_MAPPING",[qf]:"CUSTOM_TONE_MAPPING"};function RT(i,e,t,n,s,r){let o=new ti(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new pn;h.setAttribute("position",new $t([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new $t([0,2,0,0,2,0],2));let u=new hh({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new en(h,u),f=new $o(-1,1,1,-1,0,1),m=null,y=null,p=!1,g,v=null,M=[],_=!1;this.setSize=function(E,T){o.setSize(E,T),a!==null&&a.setSize(E,T),l!==null&&l.setSize(E,T);for(let x=0;x<M.length;x++){let S=M[x];S.setSize&&S.setSize(E,T)}},this.setEffects=function(E){M=E,_=M.length>0&&M[0].isRenderPass===!0;let T=o.width,x=o.height;M.length>0&&a===null&&(a=new ti(T,x,{type:Xi,depthBuffer:!1,stencilBuffer:!1}),l=new ti(T,x,{type:Xi,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&M.some(O=>O.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new Os(T,x),r===!0&&(c.format=zs,c.type=zr)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let O=0;O<M.length;O++){let L=M[O];L.setSize&&L.setSize(T,x),S&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(E,T){if(p||E.toneMapping===gs&&M.length===0)return!1;if(v=T,T!==null){let x=T.width,S=T.height;(o.width!==x||o.height!==S)&&this.setSize(x,S)}return _===!1&&E.setRenderTarget(o),g=E.toneMapping,E.toneMapping=gs,!0},this.hasRenderPass=function(){return _},this.end=function(E,T){E.toneMapping=g,p=!0;let x=o,S=a;for(let O=0;O<M.length;O++){let L=M[O];L.enabled!==!1&&(L.render(E,S,x,T),L.needsSwap!==!1&&(x=S,S=S===a?l:a))}if(m!==E.outputColorSpace||y!==E.toneMapping){m=E.outputColorSpace,y=E.toneMapping,u.defines={},Rt.getTransfer(m)===Bt&&(u.defines.SRGB_TRANSFER="");let O=CT[y];O&&(u.defines[O]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,E.setRenderTarget(v),E.render(d,f),v=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var $v=new si,Yv=new Os(1,1),Jv=new Ya(1),Kv=new Ha,Zv=new Zc,jv=new $a,Tv=[],Av=[],Cv=new Float32Array(16),Rv=new Float32Array(9),Pv=new Float32Array(4);function ta(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Tv[s];if(r===void 0&&(r=new Float32Array(s),Tv[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Cn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Rn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function pu(i,e){let t=Av[e];t===void 0&&(t=new Int32Array(e),Av[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function PT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function IT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;i.uniform2fv(this.addr,e),Rn(t,e)}}function LT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Cn(t,e))return;i.uniform3fv(this.addr,e),Rn(t,e)}}function NT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;i.uniform4fv(this.addr,e),Rn(t,e)}}function DT(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Cn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,n))return;Pv.set(n),i.uniformMatrix2fv(this.addr,!1,Pv),Rn(t,n)}}function FT(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Cn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,n))return;Rv.set(n),i.uniformMatrix3fv(this.addr,!1,Rv),Rn(t,n)}}function UT(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Cn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,n))return;Cv.set(n),i.uniformMatrix4fv(this.addr,!1,Cv),Rn(t,n)}}function OT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function kT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;i.uniform2iv(this.addr,e),Rn(t,e)}}function BT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;i.uniform3iv(this.addr,e),Rn(t,e)}}function zT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;i.uniform4iv(this.addr,e),Rn(t,e)}}function VT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function GT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;i.uniform2uiv(this.addr,e),Rn(t,e)}}function HT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;i.uniform3uiv(this.addr,e),Rn(t,e)}}function WT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;i.uniform4uiv(this.addr,e),Rn(t,e)}}function mu(i){return i.version===0&&(i.compareFunction=op,i.needsUpdate=!0),i}function XT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=mu(Yv):r=$v,t.setTexture2D(e||r,s)}function qT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Zv,s)}function $T(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=mu(Jv):r=jv,t.setTextureCube(e||r,s)}function YT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Kv,s)}function JT(i){switch(i){case 5126:return PT;case 35664:return IT;case 35665:return LT;case 35666:return NT;case 35674:return DT;case 35675:return FT;case 35676:return UT;case 5124:case 35670:return OT;case 35667:case 35671:return kT;case 35668:case 35672:return BT;case 35669:case 35673:return zT;case 5125:return VT;case 36294:return GT;case 36295:return HT;case 36296:return WT;case 35678:case 36198:case 36298:case 36306:case 35682:return XT;case 35679:case 36299:case 36307:return qT;case 35680:case 36300:case 36308:case 36293:return $T;case 36289:case 36303:case 36311:case 36292:return YT}}function KT(i,e){i.uniform1fv(this.addr,e)}function ZT(i,e){let t=ta(e,this.size,2);i.uniform2fv(this.addr,t)}function jT(i,e){let t=ta(e,this.size,3);i.uniform3fv(this.addr,t)}function QT(i,e){let t=ta(e,this.size,4);i.uniform4fv(this.addr,t)}function eA(i,e){let t=ta(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function tA(i,e){let t=ta(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function nA(i,e){let t=ta(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function iA(i,e){i.uniform1iv(this.addr,e)}function sA(i,e){i.uniform2iv(this.addr,e)}function rA(i,e){i.uniform3iv(this.addr,e)}function oA(i,e){i.uniform4iv(this.addr,e)}function aA(i,e){i.uniform1uiv(this.addr,e)}function lA(i,e){i.uniform2uiv(this.addr,e)}function cA(i,e){i.uniform3uiv(this.addr,e)}function hA(i,e){i.uniform4uiv(this.addr,e)}function uA(i,e,t){let n=this.cache,s=e.length,r=pu(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Rn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=mu(Yv):o=$v;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function dA(i,e,t){let n=this.cache,s=e.length,r=pu(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Rn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Zv,r[o])}function fA(i,e,t){let n=this.cache,s=e.length,r=pu(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Rn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=mu(Jv):o=jv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function pA(i,e,t){let n=this.cache,s=e.length,r=pu(t,s);Cn(n,r)||(i.uniform1iv(this.addr,r),Rn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Kv,r[o])}function mA(i){switch(i){case 5126:return KT;case 35664:return ZT;case 35665:return jT;case 35666:return QT;case 35674:return eA;case 35675:return tA;case 35676:return nA;case 5124:case 35670:return iA;case 35667:case 35671:return sA;case 35668:case 35672:return rA;case 35669:case 35673:return oA;case 5125:return aA;case 36294:return lA;case 36295:return cA;case 36296:return hA;case 35678:case 36198:case 36298:case 36306:case 35682:return uA;case 35679:case 36299:case 36307:return dA;case 35680:case 36300:case 36308:case 36293:return fA;case 36289:case 36303:case 36311:case 36292:return pA}}var yp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=JT(t.type)}},vp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=mA(t.type)}},xp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},mp=/(\w+)(\])?(\[|\.)?/g;function Iv(i,e){i.seq.push(e),i.map[e.id]=e}function gA(i,e,t){let n=i.name,s=n.length;for(mp.lastIndex=0;;){let r=mp.exec(n),o=mp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Iv(t,c===void 0?new yp(a,i,e):new vp(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new xp(a),Iv(t,u)),t=u}}}var ea=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);gA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function Lv(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var yA=37297,vA=0;function xA(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var Nv=new mt;function _A(i){Rt._getMatrix(Nv,Rt.workingColorSpace,i);let e=`mat3( ${Nv.elements.map(t=>t.toFixed(4))} )`;switch(Rt.getTransfer(i)){case za:return[e,"LinearTransferOETF"];case Bt:return[e,"sRGBTransferOETF"];default:return it("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Dv(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+xA(i.getShaderSource(e),a)}else return r}function bA(i,e){let t=_A(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var MA={[Gf]:"Linear",[Hf]:"Reinhard",[Wf]:"Cineon",[Xf]:"ACESFilmic",[$f]:"AgX",[Yf]:"Neutral",[qf]:"Custom"};function SA(i,e){let t=MA[e];return t===void 0?(it("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var uu=new F;function wA(){Rt.getLuminanceCoefficients(uu);let i=uu.x.toFixed(4),e=uu.y.toFixed(4),t=uu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function EA(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(yl).join(`
`)}function TA(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function AA(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function yl(i){return i!==""}function Fv(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Uv(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var CA=/^[ \t]*#include +<([\w\d./]+)>/gm;function _p(i){return i.replace(CA,RA)}function RA(i,e){let t=bt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return _p(t)}var PA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ov(i){return i.replace(PA,IA)}function IA(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function kv(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var LA={[al]:"SHADOWMAP_TYPE_PCF",[Jo]:"SHADOWMAP_TYPE_VSM"};function NA(i){return LA[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var DA={[Zo]:"ENVMAP_MODE_REFRACTION"};function FA(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":DA[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var UA={[Vf]:"ENVMAP_BLENDING_MULTIPLY",[jy]:"ENVMAP_BLENDING_MIX",[Qy]:"ENVMAP_BLENDING_ADD"};function OA(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":UA[i.combine]||"ENVMAP_BLENDING_NONE"}function kA(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=NA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=FA(t),u=OA(t),d=EA(t),f=TA(r),m=s.createProgram(),y,p,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(yl).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(yl).join(`
`),p.length>0&&(p+=`
`)):(y=[kv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(yl).join(`
`),p=[kv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==gs?"#define TONE_MAPPING":"",t.toneMapping!==gs?bt.tonemapping_pars_fragment:"",t.toneMapping!==gs?SA("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",bt.colorspace_pars_fragment,bA("linearToOutputTexel",t.outputColorSpace),wA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(yl).join(`
`)),o=_p(o),o=Fv(o,t),o=Uv(o,t),a=_p(a),a=Fv(a,t),a=Uv(a,t),o=Ov(o),a=Ov(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",t.glslVersion===ap?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===ap?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let v=g+y+o,M=g+p+a,_=Lv(s,s.VERTEX_SHADER,v),E=Lv(s,s.FRAGMENT_SHADER,M);s.attachShader(m,_),s.attachShader(m,E),t.index0AttributeName!==void 0?s.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function T(L){if(i.debug.checkShaderErrors){let R=s.getProgramInfoLog(m)||"",U=s.getShaderInfoLog(_)||"",z=s.getShaderInfoLog(E)||"",I=R.trim(),G=U.trim(),q=z.trim(),H=!0,he=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,m,_,E);else{let Y=Dv(s,_,"vertex"),ee=Dv(s,E,"fragment");ut("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+I+`
`+Y+`
`+ee)}else I!==""?it("WebGLProgram: Program Info Log:",I):(G===""||q==="")&&(he=!1);he&&(L.diagnostics={runnable:H,programLog:I,vertexShader:{log:G,prefix:y},fragmentShader:{log:q,prefix:p}})}s.deleteShader(_),s.deleteShader(E),x=new ea(s,m),S=AA(s,m)}let x;this.getUniforms=function(){return x===void 0&&T(this),x};let S;this.getAttributes=function(){return S===void 0&&T(this),S};let O=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(m,yA)),O},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=vA++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=_,this.fragmentShader=E,this}var BA=0,bp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Mp(e),t.set(e,n)),n}},Mp=class{constructor(e){this.id=BA++,this.code=e,this.usedTimes=0}};function zA(i){return i===pr||i===fl||i===pl}function VA(i,e,t,n,s,r){let o=new Wa,a=new bp,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function m(x,S,O,L,R,U){let z=L.fog,I=R.geometry,G=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?L.environment:null,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,H=e.get(x.envMap||G,q),he=d[x.type],Y=n.precision;x.precision!==null&&(Y=n.getMaxPrecision(x.precision),Y!==x.precision&&it("WebGLProgram.getParameters:",x.precision,"not supported, using",Y,"instead."));let ee=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,J=ee!==void 0?ee.length:0,ae=0;I.morphAttributes.position!==void 0&&(ae=1),I.morphAttributes.normal!==void 0&&(ae=2),I.morphAttributes.color!==void 0&&(ae=3);let re,Q,pe,ye;if(he){let Ne=vs[he];re=Ne.vertexShader,Q=Ne.fragmentShader}else{re=x.vertexShader,Q=x.fragmentShader;let Ne=a.getVertexShaderStage(x),vt=a.getFragmentShaderStage(x);a.update(x,Ne,vt),pe=Ne.id,ye=vt.id}let Ae=i.getRenderTarget(),Se=i.state.buffers.depth.getReversed(),He=R.isInstancedMesh===!0,ot=R.isBatchedMesh===!0,Ze=!!x.map,at=!!x.matcap,rt=!!H,le=rt&&H.isPMREMTexture===!0,xe=!!x.aoMap,ve=!!x.lightMap,Be=!!x.bumpMap&&x.wireframe===!1,Le=!!x.normalMap,st=!!x.displacementMap,ze=!!x.emissiveMap,yt=!!x.metalnessMap,pt=!!x.roughnessMap,xt=x.anisotropy>0,B=x.clearcoat>0,be=x.diffuseRoughness>0,qe=x.dispersion>0,dt=x.retroreflectivity>0,we=x.iridescence>0,Ot=x.sheen>0,Je=x.transmission>0,nt=xt&&!!x.anisotropyMap,P=B&&!!x.clearcoatMap,w=B&&!!x.clearcoatNormalMap,$=B&&!!x.clearcoatRoughnessMap,fe=be&&!!x.diffuseRoughnessMap,ce=we&&!!x.iridescenceMap,Me=we&&!!x.iridescenceThicknessMap,Ee=Ot&&!!x.sheenColorMap,ne=Ot&&!!x.sheenRoughnessMap,se=!!x.specularMap,ge=!!x.specularColorMap,V=!!x.specularIntensityMap,oe=Je&&!!x.transmissionMap,ie=Je&&!!x.thicknessMap,Re=!!x.gradientMap,_e=!!x.alphaMap,Ce=x.alphaTest>0,Qe=!!x.alphaHash,ct=!!x.extensions,de=gs;x.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(de=i.toneMapping);let $e=le?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,ht={shaderID:he,shaderType:x.type,shaderName:x.name,vertexShader:re,fragmentShader:Q,defines:x.defines,customVertexShaderID:pe,customFragmentShaderID:ye,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Y,batching:ot,batchingColor:ot&&R._colorsTexture!==null,instancing:He,instancingColor:He&&R.instanceColor!==null,instancingMorph:He&&R.morphTexture!==null,outputColorSpace:Ae===null?i.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:Rt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ze,matcap:at,envMap:rt,envMapMode:rt&&H.mapping,envMapPMREM:le,envMapMaxLod:le?$e.length-1:null,envMapSize:le?$e[0].width:null,aoMap:xe,lightMap:ve,bumpMap:Be,normalMap:Le,displacementMap:st,emissiveMap:ze,normalMapObjectSpace:Le&&x.normalMapType===nv,normalMapTangentSpace:Le&&x.normalMapType===ip,packedNormalMap:Le&&x.normalMapType===ip&&zA(x.normalMap.format),metalnessMap:yt,roughnessMap:pt,anisotropy:xt,anisotropyMap:nt,clearcoat:B,clearcoatMap:P,clearcoatNormalMap:w,clearcoatRoughnessMap:$,diffuseRoughness:be,diffuseRoughnessMap:fe,dispersion:qe,retroreflection:dt,iridescence:we,iridescenceMap:ce,iridescenceThicknessMap:Me,sheen:Ot,sheenColorMap:Ee,sheenRoughnessMap:ne,specularMap:se,specularColorMap:ge,specularIntensityMap:V,transmission:Je,transmissionMap:oe,thicknessMap:ie,gradientMap:Re,opaque:x.transparent===!1&&x.blending===Ko&&x.alphaToCoverage===!1,alphaMap:_e,alphaTest:Ce,alphaHash:Qe,combine:x.combine,mapUv:Ze&&f(x.map.channel),aoMapUv:xe&&f(x.aoMap.channel),lightMapUv:ve&&f(x.lightMap.channel),bumpMapUv:Be&&f(x.bumpMap.channel),normalMapUv:Le&&f(x.normalMap.channel),displacementMapUv:st&&f(x.displacementMap.channel),emissiveMapUv:ze&&f(x.emissiveMap.channel),metalnessMapUv:yt&&f(x.metalnessMap.channel),roughnessMapUv:pt&&f(x.roughnessMap.channel),anisotropyMapUv:nt&&f(x.anisotropyMap.channel),clearcoatMapUv:P&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:fe&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:ce&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:Me&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:Ee&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:ne&&f(x.sheenRoughnessMap.channel),specularMapUv:se&&f(x.specularMap.channel),specularColorMapUv:ge&&f(x.specularColorMap.channel),specularIntensityMapUv:V&&f(x.specularIntensityMap.channel),transmissionMapUv:oe&&f(x.transmissionMap.channel),thicknessMapUv:ie&&f(x.thicknessMap.channel),alphaMapUv:_e&&f(x.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Le||xt),vertexNormals:!!I.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:R.isPoints===!0&&!!I.attributes.uv&&(Ze||_e),fog:!!z,useFog:x.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||I.attributes.normal===void 0&&Le===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Se,skinning:R.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:J,morphTextureStride:ae,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:U.filter(Ne=>Ne.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&O.length>0,shadowMapType:i.shadowMap.type,toneMapping:de,decodeVideoTexture:Ze&&x.map.isVideoTexture===!0&&Rt.getTransfer(x.map.colorSpace)===Bt,decodeVideoTextureEmissive:ze&&x.emissiveMap.isVideoTexture===!0&&Rt.getTransfer(x.emissiveMap.colorSpace)===Bt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===ms,flipSided:x.side===ni,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:ct&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ct&&x.extensions.multiDraw===!0||ot)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return ht.vertexUv1s=l.has(1),ht.vertexUv2s=l.has(2),ht.vertexUv3s=l.has(3),l.clear(),ht}function y(x){let S=[];if(x.shaderID?S.push(x.shaderID):(S.push(x.customVertexShaderID),S.push(x.customFragmentShaderID)),x.defines!==void 0)for(let O in x.defines)S.push(O),S.push(x.defines[O]);return x.isRawShaderMaterial===!1&&(p(S,x),g(S,x),S.push(i.outputColorSpace)),S.push(x.customProgramCacheKey),S.join()}function p(x,S){x.push(S.precision),x.push(S.outputColorSpace),x.push(S.envMapMode),x.push(S.envMapPMREM),x.push(S.envMapMaxLod),x.push(S.envMapSize),x.push(S.mapUv),x.push(S.alphaMapUv),x.push(S.lightMapUv),x.push(S.aoMapUv),x.push(S.bumpMapUv),x.push(S.normalMapUv),x.push(S.displacementMapUv),x.push(S.emissiveMapUv),x.push(S.metalnessMapUv),x.push(S.roughnessMapUv),x.push(S.anisotropyMapUv),x.push(S.clearcoatMapUv),x.push(S.clearcoatNormalMapUv),x.push(S.clearcoatRoughnessMapUv),x.push(S.diffuseRoughnessMapUv),x.push(S.iridescenceMapUv),x.push(S.iridescenceThicknessMapUv),x.push(S.sheenColorMapUv),x.push(S.sheenRoughnessMapUv),x.push(S.specularMapUv),x.push(S.specularColorMapUv),x.push(S.specularIntensityMapUv),x.push(S.transmissionMapUv),x.push(S.thicknessMapUv),x.push(S.combine),x.push(S.fogExp2),x.push(S.sizeAttenuation),x.push(S.morphTargetsCount),x.push(S.numSunLights),x.push(S.numDirLights),x.push(S.numPointLights),x.push(S.numSpotLights),x.push(S.numSpotLightMaps),x.push(S.numHemiLights),x.push(S.numRectAreaLights),x.push(S.numSunLightShadows),x.push(S.numDirLightShadows),x.push(S.numPointLightShadows),x.push(S.numSpotLightShadows),x.push(S.numSpotLightShadowsWithMaps),x.push(S.numLightProbes),x.push(S.numLightProbeGrids),x.push(S.shadowMapType),x.push(S.toneMapping),x.push(S.numClippingPlanes),x.push(S.numClipIntersection),x.push(S.depthPacking)}function g(x,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let S=d[x.type],O;if(S){let L=vs[S];O=xv.clone(L.uniforms)}else O=x.uniforms;return O}function M(x,S){let O=h.get(S);return O!==void 0?++O.usedTimes:(O=new kA(i,S,x,s),c.push(O),h.set(S,O)),O}function _(x){if(--x.usedTimes===0){let S=c.indexOf(x);c[S]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function E(x){a.remove(x)}function T(){a.dispose()}return{getParameters:m,getProgramCacheKey:y,getUniforms:v,acquireProgram:M,releaseProgram:_,releaseShaderCache:E,programs:c,dispose:T}}function GA(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function HA(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Bv(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function zv(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,m,y,p,g){let v=i[e];return v===void 0?(v={id:d.id,object:d,geometry:f,material:m,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:p,group:g},i[e]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=m,v.materialVariant=o(d),v.groupOrder=y,v.renderOrder=d.renderOrder,v.z=p,v.group=g),e++,v}function l(d,f,m,y,p,g,v){v.reversedDepth===!0&&(p=-p);let M=a(d,f,m,y,p,g);m.transmission>0?n.push(M):m.transparent===!0?s.push(M):t.push(M)}function c(d,f,m,y,p,g){let v=a(d,f,m,y,p,g);m.transmission>0?n.unshift(v):m.transparent===!0?s.unshift(v):t.unshift(v)}function h(d,f){t.length>1&&t.sort(d||HA),n.length>1&&n.sort(f||Bv),s.length>1&&s.sort(f||Bv)}function u(){for(let d=e,f=i.length;d<f;d++){let m=i[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function WA(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new zv,i.set(n,[o])):s>=r.length?(o=new zv,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function XA(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new F,color:new Pt};break;case"SpotLight":t={position:new F,direction:new F,color:new Pt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new F,color:new Pt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new F,skyColor:new Pt,groundColor:new Pt};break;case"RectAreaLight":t={color:new Pt,position:new F,halfWidth:new F,halfHeight:new F};break}return i[e.id]=t,t}}}function qA(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Fe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Fe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Fe,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var $A=0;function YA(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function JA(i){let e=new XA,t=qA(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new F);let s=new F,r=new Ht,o=new Ht;function a(c){let h=0,u=0,d=0;for(let U=0;U<9;U++)n.probe[U].set(0,0,0);let f=0,m=0,y=0,p=0,g=0,v=0,M=0,_=0,E=0,T=0,x=0,S=0,O=0,L=0;c.sort(YA);for(let U=0,z=c.length;U<z;U++){let I=c[U],G=I.color,q=I.intensity,H=I.distance,he=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===pr?he=I.shadow.map.texture:he=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=G.r*q,u+=G.g*q,d+=G.b*q;else if(I.isLightProbe){for(let Y=0;Y<9;Y++)n.probe[Y].addScaledVector(I.sh.coefficients[Y],q);L++}else if(I.isSunLight){let Y=e.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let ee=I.shadow,J=t.get(I);J.shadowIntensity=ee.intensity,J.shadowBias=ee.bias,J.shadowNormalBias=ee.normalBias,J.shadowRadius=ee.radius,J.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),n.sunShadow[m]=J,n.sunShadowMap[m]=he;let ae=ee.getViewportCount();for(let re=0;re<ae;re++)n.sunShadowMatrix[y+re]=ee.getMatrix(re),n.sunShadowCascade[y+re]=ee._cascadeData[re];y+=ae,m++}n.sun[f]=Y,f++}else if(I.isDirectionalLight){let Y=e.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let ee=I.shadow,J=t.get(I);J.shadowIntensity=ee.intensity,J.shadowBias=ee.bias,J.shadowNormalBias=ee.normalBias,J.shadowRadius=ee.radius,J.shadowMapSize=ee.mapSize,n.directionalShadow[p]=J,n.directionalShadowMap[p]=he,n.directionalShadowMatrix[p]=I.shadow.matrix,E++}n.directional[p]=Y,p++}else if(I.isSpotLight){let Y=e.get(I);Y.position.setFromMatrixPosition(I.matrixWorld),Y.color.copy(G).multiplyScalar(q),Y.distance=H,Y.coneCos=Math.cos(I.angle),Y.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),Y.decay=I.decay,n.spot[v]=Y;let ee=I.shadow;if(I.map&&(n.spotLightMap[S]=I.map,S++,ee.updateMatrices(I),I.castShadow&&O++),n.spotLightMatrix[v]=ee.matrix,I.castShadow){let J=t.get(I);J.shadowIntensity=ee.intensity,J.shadowBias=ee.bias,J.shadowNormalBias=ee.normalBias,J.shadowRadius=ee.radius,J.shadowMapSize=ee.mapSize,n.spotShadow[v]=J,n.spotShadowMap[v]=he,x++}v++}else if(I.isRectAreaLight){let Y=e.get(I);Y.color.copy(G).multiplyScalar(q),Y.halfWidth.set(I.width*.5,0,0),Y.halfHeight.set(0,I.height*.5,0),n.rectArea[M]=Y,M++}else if(I.isPointLight){let Y=e.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),Y.distance=I.distance,Y.decay=I.decay,I.castShadow){let ee=I.shadow,J=t.get(I);J.shadowIntensity=ee.intensity,J.shadowBias=ee.bias,J.shadowNormalBias=ee.normalBias,J.shadowRadius=ee.radius,J.shadowMapSize=ee.mapSize,J.shadowCameraNear=ee.camera.near,J.shadowCameraFar=ee.camera.far,n.pointShadow[g]=J,n.pointShadowMap[g]=he,n.pointShadowMatrix[g]=I.shadow.matrix,T++}n.point[g]=Y,g++}else if(I.isHemisphereLight){let Y=e.get(I);Y.skyColor.copy(I.color).multiplyScalar(q),Y.groundColor.copy(I.groundColor).multiplyScalar(q),n.hemi[_]=Y,_++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ke.LTC_FLOAT_1,n.rectAreaLTC2=ke.LTC_FLOAT_2):(n.rectAreaLTC1=ke.LTC_HALF_1,n.rectAreaLTC2=ke.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let R=n.hash;(R.sunLength!==f||R.directionalLength!==p||R.pointLength!==g||R.spotLength!==v||R.rectAreaLength!==M||R.hemiLength!==_||R.numSunShadows!==m||R.numDirectionalShadows!==E||R.numPointShadows!==T||R.numSpotShadows!==x||R.numSpotMaps!==S||R.numLightProbes!==L)&&(n.sun.length=f,n.directional.length=p,n.spot.length=v,n.rectArea.length=M,n.point.length=g,n.hemi.length=_,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=E,n.directionalShadowMap.length=E,n.directionalShadowMatrix.length=E,n.pointShadow.length=T,n.pointShadowMap.length=T,n.pointShadowMatrix.length=T,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+S-O,n.spotLightMap.length=S,n.numSpotLightShadowsWithMaps=O,n.numLightProbes=L,R.sunLength=f,R.directionalLength=p,R.pointLength=g,R.spotLength=v,R.rectAreaLength=M,R.hemiLength=_,R.numSunShadows=m,R.numDirectionalShadows=E,R.numPointShadows=T,R.numSpotShadows=x,R.numSpotMaps=S,R.numLightProbes=L,n.version=$A++)}function l(c,h){let u=0,d=0,f=0,m=0,y=0,p=0,g=h.matrixWorldInverse;for(let v=0,M=c.length;v<M;v++){let _=c[v];if(_.isSunLight){let E=n.sun[u];E.direction.setFromMatrixPosition(_.matrixWorld),E.direction.transformDirection(g),u++}else if(_.isDirectionalLight){let E=n.directional[d];E.direction.setFromMatrixPosition(_.matrixWorld),s.setFromMatrixPosition(_.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(g),d++}else if(_.isSpotLight){let E=n.spot[m];E.position.setFromMatrixPosition(_.matrixWorld),E.position.applyMatrix4(g),E.direction.setFromMatrixPosition(_.matrixWorld),s.setFromMatrixPosition(_.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(g),m++}else if(_.isRectAreaLight){let E=n.rectArea[y];E.position.setFromMatrixPosition(_.matrixWorld),E.position.applyMatrix4(g),o.identity(),r.copy(_.matrixWorld),r.premultiply(g),o.extractRotation(r),E.halfWidth.set(_.width*.5,0,0),E.halfHeight.set(0,_.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),y++}else if(_.isPointLight){let E=n.point[f];E.position.setFromMatrixPosition(_.matrixWorld),E.position.applyMatrix4(g),f++}else if(_.isHemisphereLight){let E=n.hemi[p];E.direction.setFromMatrixPosition(_.matrixWorld),E.direction.transformDirection(g),p++}}}return{setup:a,setupView:l,state:n}}function Vv(i){let e=new JA(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function KA(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Vv(i),e.set(s,[a])):r>=o.length?(a=new Vv(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var ZA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,jA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,QA=[new F(1,0,0),new F(-1,0,0),new F(0,1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1)],eC=[new F(0,-1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1),new F(0,-1,0),new F(0,-1,0)],Gv=new Ht,gl=new F,gp=new F;function tC(i,e,t){let n=new Nr,s=new Fe,r=new Fe,o=new on,a=new uh,l=new dh,c={},h=t.maxTextureSize,u={[fr]:ni,[ni]:fr,[ms]:ms},d=new Bn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Fe},radius:{value:4}},vertexShader:ZA,fragmentShader:jA}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let m=new pn;m.setAttribute("position",new Mn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new en(m,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=al;let g=this.type;this.render=function(T,x,S){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||T.length===0)return;this.type===Ny&&(it("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=al);let O=i.getRenderTarget(),L=i.getActiveCubeFace(),R=i.getActiveMipmapLevel(),U=i.state;U.setBlending(Or),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let z=g!==this.type;z&&x.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(G=>G.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,G=T.length;I<G;I++){let q=T[I],H=q.shadow;if(H===void 0){it("WebGLShadowMap:",q,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let he=H.getFrameExtents();s.multiply(he),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/he.x),s.x=r.x*he.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/he.y),s.y=r.y*he.y,H.mapSize.y=r.y));let Y=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Y,H.map===null||z===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===Jo){if(q.isPointLight){it("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new ti(s.x,s.y,{format:pr,type:Xi,minFilter:An,magFilter:An,generateMipmaps:!1}),H.map.texture.name=q.name+".shadowMap",H.map.depthTexture=new Os(s.x,s.y,Wi),H.map.depthTexture.name=q.name+".shadowMapDepth",H.map.depthTexture.format=Ds,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Fn,H.map.depthTexture.magFilter=Fn}else q.isPointLight?(H.map=new vl(s.x),H.map.depthTexture=new Ya(s.x,Hi)):(H.map=new ti(s.x,s.y),H.map.depthTexture=new Os(s.x,s.y,Hi)),H.map.depthTexture.name=q.name+".shadowMap",H.map.depthTexture.format=Ds,this.type===al?(H.map.depthTexture.compareFunction=Y?rp:sp,H.map.depthTexture.minFilter=An,H.map.depthTexture.magFilter=An):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Fn,H.map.depthTexture.magFilter=Fn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let ee=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();q.isPointLight!==!0&&H.updateMatrices(q,S);let J=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:S.layers;for(let ae=0;ae<ee;ae++){let re=H.getCamera(ae);if(q.isPointLight){let Q=H.camera,pe=H.matrix,ye=q.distance||Q.far;ye!==Q.far&&(Q.far=ye,Q.updateProjectionMatrix()),gl.setFromMatrixPosition(q.matrixWorld),Q.position.copy(gl),gp.copy(Q.position),gp.add(QA[ae]),Q.up.copy(eC[ae]),Q.lookAt(gp),Q.updateMatrixWorld(),pe.makeTranslation(-gl.x,-gl.y,-gl.z),Gv.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Gv,Q.coordinateSystem,Q.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,ae),i.clear();else{ae===0&&(i.setRenderTarget(H.map),i.clear());let Q=H.getViewport(ae);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),U.viewport(o)}n=H.getFrustum(ae),_(x,S,re,q,J,this.type)}H.isPointLightShadow!==!0&&this.type===Jo&&v(H,S),H.needsUpdate=!1}g=this.type,p.needsUpdate=!1,i.setRenderTarget(O,L,R)};function v(T,x){let S=e.update(y);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null?T.mapPass=new ti(s.x,s.y,{format:pr,type:Xi}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,i.setRenderTarget(T.mapPass),i.clear(),i.renderBufferDirect(x,null,S,d,y,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,i.setRenderTarget(T.map),i.clear(),i.renderBufferDirect(x,null,S,f,y,null)}function M(T,x,S,O){let L=null,R=S.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(R!==void 0)L=R;else if(L=S.isPointLight===!0?l:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let U=L.uuid,z=x.uuid,I=c[U];I===void 0&&(I={},c[U]=I);let G=I[z];G===void 0&&(G=L.clone(),I[z]=G,x.addEventListener("dispose",E)),L=G}if(L.visible=x.visible,L.wireframe=x.wireframe,O===Jo?L.side=x.shadowSide!==null?x.shadowSide:x.side:L.side=x.shadowSide!==null?x.shadowSide:u[x.side],L.alphaMap=x.alphaMap,L.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,L.map=x.map,L.clipShadows=x.clipShadows,L.clippingPlanes=x.clippingPlanes,L.clipIntersection=x.clipIntersection,L.displacementMap=x.displacementMap,L.displacementScale=x.displacementScale,L.displacementBias=x.displacementBias,L.wireframeLinewidth=x.wireframeLinewidth,L.linewidth=x.linewidth,S.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let U=i.properties.get(L);U.light=S}return L}function _(T,x,S,O,L,R){if(T.visible===!1)return;if(T.layers.test(L)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&R===Jo)&&(!T.frustumCulled||T.intersectsFrustum(n))){T.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,T.matrixWorld);let I=e.update(T),G=T.material;if(Array.isArray(G)){let q=I.groups;for(let H=0,he=q.length;H<he;H++){let Y=q[H],ee=G[Y.materialIndex];if(ee&&ee.visible){let J=M(T,ee,O,R);T.onBeforeShadow(i,T,x,S,I,J,Y),i.renderBufferDirect(S,null,I,J,T,Y),T.onAfterShadow(i,T,x,S,I,J,Y)}}}else if(G.visible){let q=M(T,G,O,R);T.onBeforeShadow(i,T,x,S,I,q,null),i.renderBufferDirect(S,null,I,q,T,null),T.onAfterShadow(i,T,x,S,I,q,null)}}let z=T.children;for(let I=0,G=z.length;I<G;I++)_(z[I],x,S,O,L,R)}function E(T){T.target.removeEventListener("dispose",E);for(let S in c){let O=c[S],L=T.target.uuid;L in O&&(O[L].dispose(),delete O[L])}}}function nC(i,e){function t(){let V=!1,oe=new on,ie=null,Re=new on(0,0,0,0);return{setMask:function(_e){ie!==_e&&!V&&(i.colorMask(_e,_e,_e,_e),ie=_e)},setLocked:function(_e){V=_e},setClear:function(_e,Ce,Qe,ct,de){de===!0&&(_e*=ct,Ce*=ct,Qe*=ct),oe.set(_e,Ce,Qe,ct),Re.equals(oe)===!1&&(i.clearColor(_e,Ce,Qe,ct),Re.copy(oe))},reset:function(){V=!1,ie=null,Re.set(-1,0,0,0)}}}function n(){let V=!1,oe=!1,ie=null,Re=null,_e=null;return{setReversed:function(Ce){if(oe!==Ce){let Qe=e.get("EXT_clip_control");Ce?Qe.clipControlEXT(Qe.LOWER_LEFT_EXT,Qe.ZERO_TO_ONE_EXT):Qe.clipControlEXT(Qe.LOWER_LEFT_EXT,Qe.NEGATIVE_ONE_TO_ONE_EXT),oe=Ce;let ct=_e;_e=null,this.setClear(ct)}},getReversed:function(){return oe},setTest:function(Ce){Ce?Se(i.DEPTH_TEST):He(i.DEPTH_TEST)},setMask:function(Ce){ie!==Ce&&!V&&(i.depthMask(Ce),ie=Ce)},setFunc:function(Ce){if(oe&&(Ce=dv[Ce]),Re!==Ce){switch(Ce){case zc:i.depthFunc(i.NEVER);break;case Vc:i.depthFunc(i.ALWAYS);break;case Gc:i.depthFunc(i.LESS);break;case No:i.depthFunc(i.LEQUAL);break;case Hc:i.depthFunc(i.EQUAL);break;case Wc:i.depthFunc(i.GEQUAL);break;case Do:i.depthFunc(i.GREATER);break;case Xc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Re=Ce}},setLocked:function(Ce){V=Ce},setClear:function(Ce){_e!==Ce&&(_e=Ce,oe&&(Ce=1-Ce),i.clearDepth(Ce))},reset:function(){V=!1,ie=null,Re=null,_e=null,oe=!1}}}function s(){let V=!1,oe=null,ie=null,Re=null,_e=null,Ce=null,Qe=null,ct=null,de=null;return{setTest:function($e){V||($e?Se(i.STENCIL_TEST):He(i.STENCIL_TEST))},setMask:function($e){oe!==$e&&!V&&(i.stencilMask($e),oe=$e)},setFunc:function($e,ht,Ne){(ie!==$e||Re!==ht||_e!==Ne)&&(i.stencilFunc($e,ht,Ne),ie=$e,Re=ht,_e=Ne)},setOp:function($e,ht,Ne){(Ce!==$e||Qe!==ht||ct!==Ne)&&(i.stencilOp($e,ht,Ne),Ce=$e,Qe=ht,ct=Ne)},setLocked:function($e){V=$e},setClear:function($e){de!==$e&&(i.clearStencil($e),de=$e)},reset:function(){V=!1,oe=null,ie=null,Re=null,_e=null,Ce=null,Qe=null,ct=null,de=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,m=[],y=null,p=!1,g=null,v=null,M=null,_=null,E=null,T=null,x=null,S=new Pt(0,0,0),O=0,L=!1,R=null,U=null,z=null,I=null,G=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,he=0,Y=i.getParameter(i.VERSION);Y.indexOf("WebGL")!==-1?(he=parseFloat(/^WebGL (\d)/.exec(Y)[1]),H=he>=1):Y.indexOf("OpenGL ES")!==-1&&(he=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),H=he>=2);let ee=null,J={},ae=i.getParameter(i.SCISSOR_BOX),re=i.getParameter(i.VIEWPORT),Q=new on().fromArray(ae),pe=new on().fromArray(re);function ye(V,oe,ie,Re){let _e=new Uint8Array(4),Ce=i.createTexture();i.bindTexture(V,Ce),i.texParameteri(V,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(V,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Qe=0;Qe<ie;Qe++)V===i.TEXTURE_3D||V===i.TEXTURE_2D_ARRAY?i.texImage3D(oe,0,i.RGBA,1,1,Re,0,i.RGBA,i.UNSIGNED_BYTE,_e):i.texImage2D(oe+Qe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,_e);return Ce}let Ae={};Ae[i.TEXTURE_2D]=ye(i.TEXTURE_2D,i.TEXTURE_2D,1),Ae[i.TEXTURE_CUBE_MAP]=ye(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[i.TEXTURE_2D_ARRAY]=ye(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ae[i.TEXTURE_3D]=ye(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Se(i.DEPTH_TEST),o.setFunc(No),Be(!1),Le(Ff),Se(i.CULL_FACE),xe(Or);function Se(V){h[V]!==!0&&(i.enable(V),h[V]=!0)}function He(V){h[V]!==!1&&(i.disable(V),h[V]=!1)}function ot(V,oe){return d[V]!==oe?(i.bindFramebuffer(V,oe),d[V]=oe,V===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=oe),V===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=oe),!0):!1}function Ze(V,oe){let ie=m,Re=!1;if(V){ie=f.get(oe),ie===void 0&&(ie=[],f.set(oe,ie));let _e=V.textures;if(ie.length!==_e.length||ie[0]!==i.COLOR_ATTACHMENT0){for(let Ce=0,Qe=_e.length;Ce<Qe;Ce++)ie[Ce]=i.COLOR_ATTACHMENT0+Ce;ie.length=_e.length,Re=!0}}else ie[0]!==i.BACK&&(ie[0]=i.BACK,Re=!0);Re&&i.drawBuffers(ie)}function at(V){return y!==V?(i.useProgram(V),y=V,!0):!1}let rt={[kr]:i.FUNC_ADD,[Fy]:i.FUNC_SUBTRACT,[Uy]:i.FUNC_REVERSE_SUBTRACT};rt[Oy]=i.MIN,rt[ky]=i.MAX;let le={[By]:i.ZERO,[zy]:i.ONE,[Vy]:i.SRC_COLOR,[Bf]:i.SRC_ALPHA,[$y]:i.SRC_ALPHA_SATURATE,[Xy]:i.DST_COLOR,[Hy]:i.DST_ALPHA,[Gy]:i.ONE_MINUS_SRC_COLOR,[zf]:i.ONE_MINUS_SRC_ALPHA,[qy]:i.ONE_MINUS_DST_COLOR,[Wy]:i.ONE_MINUS_DST_ALPHA,[Yy]:i.CONSTANT_COLOR,[Jy]:i.ONE_MINUS_CONSTANT_COLOR,[Ky]:i.CONSTANT_ALPHA,[Zy]:i.ONE_MINUS_CONSTANT_ALPHA};function xe(V,oe,ie,Re,_e,Ce,Qe,ct,de,$e){if(V===Or){p===!0&&(He(i.BLEND),p=!1);return}if(p===!1&&(Se(i.BLEND),p=!0),V!==Dy){if(V!==g||$e!==L){if((v!==kr||E!==kr)&&(i.blendEquation(i.FUNC_ADD),v=kr,E=kr),$e)switch(V){case Ko:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Uf:i.blendFunc(i.ONE,i.ONE);break;case Of:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case kf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ut("WebGLState: Invalid blending: ",V);break}else switch(V){case Ko:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Uf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Of:ut("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case kf:ut("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ut("WebGLState: Invalid blending: ",V);break}M=null,_=null,T=null,x=null,S.set(0,0,0),O=0,g=V,L=$e}return}_e=_e||oe,Ce=Ce||ie,Qe=Qe||Re,(oe!==v||_e!==E)&&(i.blendEquationSeparate(rt[oe],rt[_e]),v=oe,E=_e),(ie!==M||Re!==_||Ce!==T||Qe!==x)&&(i.blendFuncSeparate(le[ie],le[Re],le[Ce],le[Qe]),M=ie,_=Re,T=Ce,x=Qe),(ct.equals(S)===!1||de!==O)&&(i.blendColor(ct.r,ct.g,ct.b,de),S.copy(ct),O=de),g=V,L=!1}function ve(V,oe){V.side===ms?He(i.CULL_FACE):Se(i.CULL_FACE);let ie=V.side===ni;oe&&(ie=!ie),Be(ie),V.blending===Ko&&V.transparent===!1?xe(Or):xe(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Re=V.stencilWrite;a.setTest(Re),Re&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),ze(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?Se(i.SAMPLE_ALPHA_TO_COVERAGE):He(i.SAMPLE_ALPHA_TO_COVERAGE)}function Be(V){R!==V&&(V?i.frontFace(i.CW):i.frontFace(i.CCW),R=V)}function Le(V){V!==Iy?(Se(i.CULL_FACE),V!==U&&(V===Ff?i.cullFace(i.BACK):V===Ly?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):He(i.CULL_FACE),U=V}function st(V){V!==z&&(H&&i.lineWidth(V),z=V)}function ze(V,oe,ie){V?(Se(i.POLYGON_OFFSET_FILL),(I!==oe||G!==ie)&&(I=oe,G=ie,o.getReversed()&&(oe=-oe,ie=-ie),i.polygonOffset(oe,ie))):He(i.POLYGON_OFFSET_FILL)}function yt(V){V?Se(i.SCISSOR_TEST):He(i.SCISSOR_TEST)}function pt(V){V===void 0&&(V=i.TEXTURE0+q-1),ee!==V&&(i.activeTexture(V),ee=V)}function xt(V,oe,ie){ie===void 0&&(ee===null?ie=i.TEXTURE0+q-1:ie=ee);let Re=J[ie];Re===void 0&&(Re={type:void 0,texture:void 0},J[ie]=Re),(Re.type!==V||Re.texture!==oe)&&(ee!==ie&&(i.activeTexture(ie),ee=ie),i.bindTexture(V,oe||Ae[V]),Re.type=V,Re.texture=oe)}function B(){let V=J[ee];V!==void 0&&V.type!==void 0&&(i.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function be(){try{i.compressedTexImage2D(...arguments)}catch(V){ut("WebGLState:",V)}}function qe(){try{i.compressedTexImage3D(...arguments)}catch(V){ut("WebGLState:",V)}}function dt(){try{i.texSubImage2D(...arguments)}catch(V){ut("WebGLState:",V)}}function we(){try{i.texSubImage3D(...arguments)}catch(V){ut("WebGLState:",V)}}function Ot(){try{i.compressedTexSubImage2D(...arguments)}catch(V){ut("WebGLState:",V)}}function Je(){try{i.compressedTexSubImage3D(...arguments)}catch(V){ut("WebGLState:",V)}}function nt(){try{i.texStorage2D(...arguments)}catch(V){ut("WebGLState:",V)}}function P(){try{i.texStorage3D(...arguments)}catch(V){ut("WebGLState:",V)}}function w(){try{i.texImage2D(...arguments)}catch(V){ut("WebGLState:",V)}}function $(){try{i.texImage3D(...arguments)}catch(V){ut("WebGLState:",V)}}function fe(V){return u[V]!==void 0?u[V]:i.getParameter(V)}function ce(V,oe){u[V]!==oe&&(i.pixelStorei(V,oe),u[V]=oe)}function Me(V){Q.equals(V)===!1&&(i.scissor(V.x,V.y,V.z,V.w),Q.copy(V))}function Ee(V){pe.equals(V)===!1&&(i.viewport(V.x,V.y,V.z,V.w),pe.copy(V))}function ne(V,oe){let ie=c.get(oe);ie===void 0&&(ie=new WeakMap,c.set(oe,ie));let Re=ie.get(V);Re===void 0&&(Re=i.getUniformBlockIndex(oe,V.name),i.uniformBlockBinding(oe,Re,Re),ie.set(V,Re))}function se(V,oe,ie){let _e=c.get(oe).get(V);l[_e]!==ie&&(i.bindBufferBase(i.UNIFORM_BUFFER,_e,ie),l[_e]=ie)}function ge(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},ee=null,J={},d={},l={},f=new WeakMap,m=[],y=null,p=!1,g=null,v=null,M=null,_=null,E=null,T=null,x=null,S=new Pt(0,0,0),O=0,L=!1,R=null,U=null,z=null,I=null,G=null,Q.set(0,0,i.canvas.width,i.canvas.height),pe.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Se,disable:He,bindFramebuffer:ot,drawBuffers:Ze,useProgram:at,setBlending:xe,setMaterial:ve,setFlipSided:Be,setCullFace:Le,setLineWidth:st,setPolygonOffset:ze,setScissorTest:yt,activeTexture:pt,bindTexture:xt,unbindTexture:B,compressedTexImage2D:be,compressedTexImage3D:qe,texImage2D:w,texImage3D:$,pixelStorei:ce,getParameter:fe,updateUBOMapping:ne,uniformBlockBinding:se,texStorage2D:nt,texStorage3D:P,texSubImage2D:dt,texSubImage3D:we,compressedTexSubImage2D:Ot,compressedTexSubImage3D:Je,scissor:Me,viewport:Ee,reset:ge}}function iC(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Fe,h=new WeakMap,u=new Set,d,f=new WeakMap,m=new Set,y=new FinalizationRegistry(P=>m.delete(P)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,w){return p?new OffscreenCanvas(P,w):Ga("canvas")}function v(P,w,$){let fe=1,ce=nt(P);if((ce.width>$||ce.height>$)&&(fe=$/Math.max(ce.width,ce.height)),fe<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let Me=Math.floor(fe*ce.width),Ee=Math.floor(fe*ce.height);d===void 0&&(d=g(Me,Ee));let ne=w?g(Me,Ee):d;return ne.width=Me,ne.height=Ee,ne.getContext("2d").drawImage(P,0,0,Me,Ee),it("WebGLRenderer: Texture has been resized from ("+ce.width+"x"+ce.height+") to ("+Me+"x"+Ee+")."),ne}else return"data"in P&&it("WebGLRenderer: Image in DataTexture is too big ("+ce.width+"x"+ce.height+")."),P;return P}function M(P){return P.generateMipmaps}function _(P){i.generateMipmap(P)}function E(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(P,w,$,fe,ce,Me=!1){if(P!==null){if(i[P]!==void 0)return i[P];it("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let Ee;fe&&(Ee=e.get("EXT_texture_norm16"),Ee||it("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=w;if(w===i.RED&&($===i.FLOAT&&(ne=i.R32F),$===i.HALF_FLOAT&&(ne=i.R16F),$===i.UNSIGNED_BYTE&&(ne=i.R8),$===i.UNSIGNED_SHORT&&Ee&&(ne=Ee.R16_EXT),$===i.SHORT&&Ee&&(ne=Ee.R16_SNORM_EXT)),w===i.RED_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.R8UI),$===i.UNSIGNED_SHORT&&(ne=i.R16UI),$===i.UNSIGNED_INT&&(ne=i.R32UI),$===i.BYTE&&(ne=i.R8I),$===i.SHORT&&(ne=i.R16I),$===i.INT&&(ne=i.R32I)),w===i.RG&&($===i.FLOAT&&(ne=i.RG32F),$===i.HALF_FLOAT&&(ne=i.RG16F),$===i.UNSIGNED_BYTE&&(ne=i.RG8),$===i.UNSIGNED_SHORT&&Ee&&(ne=Ee.RG16_EXT),$===i.SHORT&&Ee&&(ne=Ee.RG16_SNORM_EXT)),w===i.RG_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RG8UI),$===i.UNSIGNED_SHORT&&(ne=i.RG16UI),$===i.UNSIGNED_INT&&(ne=i.RG32UI),$===i.BYTE&&(ne=i.RG8I),$===i.SHORT&&(ne=i.RG16I),$===i.INT&&(ne=i.RG32I)),w===i.RGB_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RGB8UI),$===i.UNSIGNED_SHORT&&(ne=i.RGB16UI),$===i.UNSIGNED_INT&&(ne=i.RGB32UI),$===i.BYTE&&(ne=i.RGB8I),$===i.SHORT&&(ne=i.RGB16I),$===i.INT&&(ne=i.RGB32I)),w===i.RGBA_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RGBA8UI),$===i.UNSIGNED_SHORT&&(ne=i.RGBA16UI),$===i.UNSIGNED_INT&&(ne=i.RGBA32UI),$===i.BYTE&&(ne=i.RGBA8I),$===i.SHORT&&(ne=i.RGBA16I),$===i.INT&&(ne=i.RGBA32I)),w===i.RGB&&($===i.UNSIGNED_SHORT&&Ee&&(ne=Ee.RGB16_EXT),$===i.SHORT&&Ee&&(ne=Ee.RGB16_SNORM_EXT),$===i.UNSIGNED_INT_5_9_9_9_REV&&(ne=i.RGB9_E5),$===i.UNSIGNED_INT_10F_11F_11F_REV&&(ne=i.R11F_G11F_B10F)),w===i.RGBA){let se=Me?za:Rt.getTransfer(ce);$===i.FLOAT&&(ne=i.RGBA32F),$===i.HALF_FLOAT&&(ne=i.RGBA16F),$===i.UNSIGNED_BYTE&&(ne=se===Bt?i.SRGB8_ALPHA8:i.RGBA8),$===i.UNSIGNED_SHORT&&Ee&&(ne=Ee.RGBA16_EXT),$===i.SHORT&&Ee&&(ne=Ee.RGBA16_SNORM_EXT),$===i.UNSIGNED_SHORT_4_4_4_4&&(ne=i.RGBA4),$===i.UNSIGNED_SHORT_5_5_5_1&&(ne=i.RGB5_A1)}return(ne===i.R16F||ne===i.R32F||ne===i.RG16F||ne===i.RG32F||ne===i.RGBA16F||ne===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function x(P,w){let $;return P?w===null||w===Hi||w===zr?$=i.DEPTH24_STENCIL8:w===Wi?$=i.DEPTH32F_STENCIL8:w===jo&&($=i.DEPTH24_STENCIL8,it("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Hi||w===zr?$=i.DEPTH_COMPONENT24:w===Wi?$=i.DEPTH_COMPONENT32F:w===jo&&($=i.DEPTH_COMPONENT16),$}function S(P,w){return M(P)===!0||P.isFramebufferTexture&&P.minFilter!==Fn&&P.minFilter!==An?Math.log2(Math.max(w.width,w.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?w.mipmaps.length:1}function O(P){let w=new WeakRef(P);n.get(P).__ref=w,m.add(w),y.register(P,w,w)}function L(P){let w=n.get(P).__ref;w!==void 0&&(m.delete(w),y.unregister(w))}function R(P){z(P.target)}function U(P){I(P.target)}function z(P){P.removeEventListener("dispose",R),L(P),q(P),P.isVideoTexture&&h.delete(P),P.isHTMLTexture&&u.delete(P)}function I(P){P.removeEventListener("dispose",U),L(P),he(P)}function G(){for(let P of m){let w=P.deref();w!==void 0&&(w.isRenderTarget===!0?I(w):z(w))}m.clear(),u.clear()}function q(P){let w=n.get(P);if(w.__webglInit===void 0)return;let $=P.source,fe=f.get($);if(fe){let ce=fe[w.__cacheKey];ce.usedTimes--,ce.usedTimes===0&&H(P),Object.keys(fe).length===0&&f.delete($)}n.remove(P)}function H(P){let w=n.get(P);i.deleteTexture(w.__webglTexture);let $=P.source,fe=f.get($);delete fe[w.__cacheKey],o.memory.textures--}function he(P){let w=n.get(P);w.__depthDisposeCallback&&w.__depthDisposeCallback();let $=P.depthTexture;if($&&$.renderTarget===P&&z($),P.isWebGLCubeRenderTarget)for(let ce=0;ce<6;ce++){if(Array.isArray(w.__webglFramebuffer[ce]))for(let Me=0;Me<w.__webglFramebuffer[ce].length;Me++)i.deleteFramebuffer(w.__webglFramebuffer[ce][Me]);else i.deleteFramebuffer(w.__webglFramebuffer[ce]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[ce])}else{if(Array.isArray(w.__webglFramebuffer))for(let ce=0;ce<w.__webglFramebuffer.length;ce++)i.deleteFramebuffer(w.__webglFramebuffer[ce]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let ce=0;ce<w.__webglColorRenderbuffer.length;ce++)w.__webglColorRenderbuffer[ce]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[ce]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let fe=P.textures;for(let ce=0,Me=fe.length;ce<Me;ce++){let Ee=n.get(fe[ce]);Ee.__webglTexture&&(i.deleteTexture(Ee.__webglTexture),o.memory.textures--),n.remove(fe[ce])}n.remove(P)}let Y=0;function ee(){Y=0}function J(){return Y}function ae(P){Y=P}function re(){let P=Y;return P>=s.maxTextures&&it("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,P}function Q(P){let w=[];return w.push(P.wrapS),w.push(P.wrapT),w.push(P.wrapR||0),w.push(P.magFilter),w.push(P.minFilter),w.push(P.anisotropy),w.push(P.internalFormat),w.push(P.format),w.push(P.type),w.push(P.generateMipmaps),w.push(P.mipmapsAutoUpdate),w.push(P.premultiplyAlpha),w.push(P.flipY),w.push(P.unpackAlignment),w.push(P.colorSpace),w.join()}function pe(P,w){let $=n.get(P);if(P.isVideoTexture&&Ot(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&$.__version!==P.version){let fe=P.image;if(fe===null)it("WebGLRenderer: Texture marked for update but no image data found.");else if(fe.complete===!1)it("WebGLRenderer: Texture marked for update but image is incomplete");else{ve($,P,w);return}}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,$.__webglTexture,i.TEXTURE0+w)}function ye(P,w){let $=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){ve($,P,w);return}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,$.__webglTexture,i.TEXTURE0+w)}function Ae(P,w){let $=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){ve($,P,w);return}t.bindTexture(i.TEXTURE_3D,$.__webglTexture,i.TEXTURE0+w)}function Se(P,w){let $=n.get(P);if(P.version>0&&$.__version!==P.version){Be($,P,w);return}t.bindTexture(i.TEXTURE_CUBE_MAP,$.__webglTexture,i.TEXTURE0+w)}let He={[Fo]:i.REPEAT,[us]:i.CLAMP_TO_EDGE,[qc]:i.MIRRORED_REPEAT},ot={[Fn]:i.NEAREST,[ev]:i.NEAREST_MIPMAP_NEAREST,[ll]:i.NEAREST_MIPMAP_LINEAR,[An]:i.LINEAR,[Th]:i.LINEAR_MIPMAP_NEAREST,[_i]:i.LINEAR_MIPMAP_LINEAR},Ze={[sv]:i.NEVER,[op]:i.ALWAYS,[rv]:i.LESS,[sp]:i.LEQUAL,[ov]:i.EQUAL,[rp]:i.GEQUAL,[av]:i.GREATER,[lv]:i.NOTEQUAL};function at(P,w){if(w.type===Wi&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===An||w.magFilter===Th||w.magFilter===ll||w.magFilter===_i||w.minFilter===An||w.minFilter===Th||w.minFilter===ll||w.minFilter===_i)&&it("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,He[w.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,He[w.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,He[w.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,ot[w.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,ot[w.minFilter]),w.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,Ze[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===Fn||w.minFilter!==ll&&w.minFilter!==_i||w.type===Wi&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");i.texParameterf(P,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function rt(P,w){let $=!1;P.__webglInit===void 0&&(P.__webglInit=!0,w.addEventListener("dispose",R),O(w));let fe=w.source,ce=f.get(fe);ce===void 0&&(ce={},f.set(fe,ce));let Me=Q(w);if(Me!==P.__cacheKey){ce[Me]===void 0&&(ce[Me]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ce[Me].usedTimes++;let Ee=ce[P.__cacheKey];Ee!==void 0&&(ce[P.__cacheKey].usedTimes--,Ee.usedTimes===0&&H(w)),P.__cacheKey=Me,P.__webglTexture=ce[Me].texture}return $}function le(P,w,$){return Math.floor(Math.floor(P/$)/w)}function xe(P,w,$,fe){let Me=P.updateRanges;if(Me.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,$,fe,w.data);else{Me.sort((V,oe)=>V.start-oe.start);let Ee=0;for(let V=1;V<Me.length;V++){let oe=Me[Ee],ie=Me[V],Re=oe.start+oe.count,_e=le(ie.start,w.width,4),Ce=le(oe.start,w.width,4);ie.start<=Re+1&&_e===Ce&&le(ie.start+ie.count-1,w.width,4)===_e?oe.count=Math.max(oe.count,ie.start+ie.count-oe.start):(++Ee,Me[Ee]=ie)}Me.length=Ee+1;let ne=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),ge=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let V=0,oe=Me.length;V<oe;V++){let ie=Me[V],Re=Math.floor(ie.start/4),_e=Math.ceil(ie.count/4),Ce=Re%w.width,Qe=Math.floor(Re/w.width),ct=_e,de=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Ce),t.pixelStorei(i.UNPACK_SKIP_ROWS,Qe),t.texSubImage2D(i.TEXTURE_2D,0,Ce,Qe,ct,de,$,fe,w.data)}P.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ne),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,ge)}}function ve(P,w,$){let fe=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(fe=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(fe=i.TEXTURE_3D);let ce=rt(P,w),Me=w.source;t.bindTexture(fe,P.__webglTexture,i.TEXTURE0+$);let Ee=n.get(Me);if(Me.version!==Ee.__version||ce===!0){if(t.activeTexture(i.TEXTURE0+$),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let de=Rt.getPrimaries(Rt.workingColorSpace),$e=w.colorSpace===Vs?null:Rt.getPrimaries(w.colorSpace),ht=w.colorSpace===Vs||de===$e?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ht)}t.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment);let se=v(w.image,!1,s.maxTextureSize);se=Je(w,se);let ge=r.convert(w.format,w.colorSpace),V=r.convert(w.type),oe=T(w.internalFormat,ge,V,w.normalized,w.colorSpace,w.isVideoTexture);at(fe,w);let ie,Re=w.mipmaps,_e=w.isVideoTexture!==!0,Ce=Ee.__version===void 0||ce===!0,Qe=Me.dataReady,ct=S(w,se);if(w.isDepthTexture)oe=x(w.format===zs,w.type),Ce&&(_e?t.texStorage2D(i.TEXTURE_2D,1,oe,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,oe,se.width,se.height,0,ge,V,null));else if(w.isDataTexture)if(Re.length>0){_e&&Ce&&t.texStorage2D(i.TEXTURE_2D,ct,oe,Re[0].width,Re[0].height);for(let de=0,$e=Re.length;de<$e;de++)ie=Re[de],_e?Qe&&t.texSubImage2D(i.TEXTURE_2D,de,0,0,ie.width,ie.height,ge,V,ie.data):t.texImage2D(i.TEXTURE_2D,de,oe,ie.width,ie.height,0,ge,V,ie.data);w.generateMipmaps=!1}else _e?(Ce&&t.texStorage2D(i.TEXTURE_2D,ct,oe,se.width,se.height),Qe&&xe(w,se,ge,V)):t.texImage2D(i.TEXTURE_2D,0,oe,se.width,se.height,0,ge,V,se.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){_e&&Ce&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ct,oe,Re[0].width,Re[0].height,se.depth);for(let de=0,$e=Re.length;de<$e;de++)if(ie=Re[de],w.format!==bi)if(ge!==null)if(_e){if(Qe)if(w.layerUpdates.size>0){let ht=pp(ie.width,ie.height,w.format,w.type);for(let Ne of w.layerUpdates){let vt=ie.data.subarray(Ne*ht/ie.data.BYTES_PER_ELEMENT,(Ne+1)*ht/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,de,0,0,Ne,ie.width,ie.height,1,ge,vt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,de,0,0,0,ie.width,ie.height,se.depth,ge,ie.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,de,oe,ie.width,ie.height,se.depth,0,ie.data,0,0);else it("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?Qe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,de,0,0,0,ie.width,ie.height,se.depth,ge,V,ie.data):t.texImage3D(i.TEXTURE_2D_ARRAY,de,oe,ie.width,ie.height,se.depth,0,ge,V,ie.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{_e&&Ce&&t.texStorage2D(i.TEXTURE_2D,ct,oe,Re[0].width,Re[0].height);for(let de=0,$e=Re.length;de<$e;de++)ie=Re[de],w.format!==bi?ge!==null?_e?Qe&&t.compressedTexSubImage2D(i.TEXTURE_2D,de,0,0,ie.width,ie.height,ge,ie.data):t.compressedTexImage2D(i.TEXTURE_2D,de,oe,ie.width,ie.height,0,ie.data):it("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?Qe&&t.texSubImage2D(i.TEXTURE_2D,de,0,0,ie.width,ie.height,ge,V,ie.data):t.texImage2D(i.TEXTURE_2D,de,oe,ie.width,ie.height,0,ge,V,ie.data)}else if(w.isDataArrayTexture)if(_e){if(Ce&&t.texStorage3D(i.TEXTURE_2D_ARRAY,ct,oe,se.width,se.height,se.depth),Qe)if(w.layerUpdates.size>0){let de=pp(se.width,se.height,w.format,w.type);for(let $e of w.layerUpdates){let ht=se.data.subarray($e*de/se.data.BYTES_PER_ELEMENT,($e+1)*de/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,$e,se.width,se.height,1,ge,V,ht)}w.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,ge,V,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,oe,se.width,se.height,se.depth,0,ge,V,se.data);else if(w.isData3DTexture)_e?(Ce&&t.texStorage3D(i.TEXTURE_3D,ct,oe,se.width,se.height,se.depth),Qe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,ge,V,se.data)):t.texImage3D(i.TEXTURE_3D,0,oe,se.width,se.height,se.depth,0,ge,V,se.data);else if(w.isFramebufferTexture){if(Ce)if(_e)t.texStorage2D(i.TEXTURE_2D,ct,oe,se.width,se.height);else{let de=se.width,$e=se.height;for(let ht=0;ht<ct;ht++)t.texImage2D(i.TEXTURE_2D,ht,oe,de,$e,0,ge,V,null),de>>=1,$e>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in i){let de=i.canvas;if(de.hasAttribute("layoutsubtree")||de.setAttribute("layoutsubtree","true"),se.parentNode!==de){de.appendChild(se),u.add(w),de.onpaint=$e=>{let ht=$e.changedElements;for(let Ne of u)ht.includes(Ne.image)&&(Ne.needsUpdate=!0)},de.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let ht=i.RGBA,Ne=i.RGBA,vt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ht,Ne,vt,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Re.length>0){if(_e&&Ce){let de=nt(Re[0]);t.texStorage2D(i.TEXTURE_2D,ct,oe,de.width,de.height)}for(let de=0,$e=Re.length;de<$e;de++)ie=Re[de],_e?Qe&&t.texSubImage2D(i.TEXTURE_2D,de,0,0,ge,V,ie):t.texImage2D(i.TEXTURE_2D,de,oe,ge,V,ie);w.generateMipmaps=!1}else if(_e){if(Ce){let de=nt(se);t.texStorage2D(i.TEXTURE_2D,ct,oe,de.width,de.height)}Qe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ge,V,se)}else t.texImage2D(i.TEXTURE_2D,0,oe,ge,V,se);M(w)&&w.mipmapsAutoUpdate===!0&&_(fe),Ee.__version=Me.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function Be(P,w,$){if(w.image.length!==6)return;let fe=rt(P,w),ce=w.source;t.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+$);let Me=n.get(ce);if(ce.version!==Me.__version||fe===!0){t.activeTexture(i.TEXTURE0+$);let Ee=Rt.getPrimaries(Rt.workingColorSpace),ne=w.colorSpace===Vs?null:Rt.getPrimaries(w.colorSpace),se=w.colorSpace===Vs||Ee===ne?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let ge=w.isCompressedTexture||w.image[0].isCompressedTexture,V=w.image[0]&&w.image[0].isDataTexture,oe=[];for(let Ne=0;Ne<6;Ne++)!ge&&!V?oe[Ne]=v(w.image[Ne],!0,s.maxCubemapSize):oe[Ne]=V?w.image[Ne].image:w.image[Ne],oe[Ne]=Je(w,oe[Ne]);let ie=oe[0],Re=r.convert(w.format,w.colorSpace),_e=r.convert(w.type),Ce=T(w.internalFormat,Re,_e,w.normalized,w.colorSpace),Qe=w.isVideoTexture!==!0,ct=Me.__version===void 0||fe===!0,de=ce.dataReady,$e=S(w,ie);at(i.TEXTURE_CUBE_MAP,w);let ht;if(w.isDepthTexture){if(Ce=x(w.format===zs,w.type),ct)if(Qe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ce,ie.width,ie.height);else for(let Ne=0;Ne<6;Ne++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,0,Ce,ie.width,ie.height,0,Re,_e,null)}else if(ge){Qe&&ct&&t.texStorage2D(i.TEXTURE_CUBE_MAP,$e,Ce,ie.width,ie.height);for(let Ne=0;Ne<6;Ne++){ht=oe[Ne].mipmaps;for(let vt=0;vt<ht.length;vt++){let Yt=ht[vt];w.format!==bi?Re!==null?Qe?de&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,vt,0,0,Yt.width,Yt.height,Re,Yt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,vt,Ce,Yt.width,Yt.height,0,Yt.data):it("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Qe?de&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,vt,0,0,Yt.width,Yt.height,Re,_e,Yt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,vt,Ce,Yt.width,Yt.height,0,Re,_e,Yt.data)}}}else{if(ht=w.mipmaps,Qe&&ct){ht.length>0&&$e++;let Ne=nt(oe[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,$e,Ce,Ne.width,Ne.height)}for(let Ne=0;Ne<6;Ne++)if(V){Qe?de&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,0,0,0,oe[Ne].width,oe[Ne].height,Re,_e,oe[Ne].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,0,Ce,oe[Ne].width,oe[Ne].height,0,Re,_e,oe[Ne].data);for(let vt=0;vt<ht.length;vt++){let qn=ht[vt].image[Ne].image;Qe?de&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,vt+1,0,0,qn.width,qn.height,Re,_e,qn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,vt+1,Ce,qn.width,qn.height,0,Re,_e,qn.data)}}else{Qe?de&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,0,0,0,Re,_e,oe[Ne]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,0,Ce,Re,_e,oe[Ne]);for(let vt=0;vt<ht.length;vt++){let Yt=ht[vt];Qe?de&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,vt+1,0,0,Re,_e,Yt.image[Ne]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ne,vt+1,Ce,Re,_e,Yt.image[Ne])}}}M(w)&&w.mipmapsAutoUpdate===!0&&_(i.TEXTURE_CUBE_MAP),Me.__version=ce.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function Le(P,w,$,fe,ce,Me){let Ee=r.convert($.format,$.colorSpace),ne=r.convert($.type),se=T($.internalFormat,Ee,ne,$.normalized,$.colorSpace),ge=n.get(w),V=n.get($);if(V.__renderTarget=w,!ge.__hasExternalTextures){let oe=Math.max(1,w.width>>Me),ie=Math.max(1,w.height>>Me);ce===i.TEXTURE_3D||ce===i.TEXTURE_2D_ARRAY?t.texImage3D(ce,Me,se,oe,ie,w.depth,0,Ee,ne,null):t.texImage2D(ce,Me,se,oe,ie,0,Ee,ne,null)}t.bindFramebuffer(i.FRAMEBUFFER,P),we(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,fe,ce,V.__webglTexture,0,dt(w)):(ce===i.TEXTURE_2D||ce>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ce<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,fe,ce,V.__webglTexture,Me),t.bindFramebuffer(i.FRAMEBUFFER,null)}function st(P,w,$){if(i.bindRenderbuffer(i.RENDERBUFFER,P),w.depthBuffer){let fe=w.depthTexture,ce=fe&&fe.isDepthTexture?fe.type:null,Me=x(w.stencilBuffer,ce),Ee=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;we(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,dt(w),Me,w.width,w.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,dt(w),Me,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,Me,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Ee,i.RENDERBUFFER,P)}else{let fe=w.textures;for(let ce=0;ce<fe.length;ce++){let Me=fe[ce],Ee=r.convert(Me.format,Me.colorSpace),ne=r.convert(Me.type),se=T(Me.internalFormat,Ee,ne,Me.normalized,Me.colorSpace);we(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,dt(w),se,w.width,w.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,dt(w),se,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,se,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function ze(P,w,$){let fe=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,P),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ce=n.get(w.depthTexture);ce.__renderTarget=w;let Me=fe?w.depthTexture.image[0]:w.depthTexture.image;(!ce.__webglTexture||Me.width!==w.width||Me.height!==w.height)&&(Me.width=w.width,Me.height=w.height,w.depthTexture.needsUpdate=!0),fe?Se(w.depthTexture,0):pe(w.depthTexture,0);let Ee=ce.__webglTexture,ne=dt(w),se=fe?i.TEXTURE_CUBE_MAP_POSITIVE_X+$:i.TEXTURE_2D,ge=w.depthTexture.format===zs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(w.depthTexture.format===Ds)we(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ge,se,Ee,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,ge,se,Ee,0);else if(w.depthTexture.format===zs)we(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ge,se,Ee,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,ge,se,Ee,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function yt(P){let w=n.get(P),$=P.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==P.depthTexture){let fe=P.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),fe){let ce=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,fe.removeEventListener("dispose",ce)};fe.addEventListener("dispose",ce),w.__depthDisposeCallback=ce}w.__boundDepthTexture=fe}if(P.depthTexture&&!w.__autoAllocateDepthBuffer)if($)for(let fe=0;fe<6;fe++)ze(w.__webglFramebuffer[fe],P,fe);else P.texture.mipmaps.length>0?ze(w.__webglFramebuffer[0],P,0):ze(w.__webglFramebuffer,P,0);else if($){w.__webglDepthbuffer=[];for(let fe=0;fe<6;fe++)if(t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[fe]),w.__webglDepthbuffer[fe]===void 0)w.__webglDepthbuffer[fe]=i.createRenderbuffer(),st(w.__webglDepthbuffer[fe],P,!1);else{let ce=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Me=w.__webglDepthbuffer[fe];i.bindRenderbuffer(i.RENDERBUFFER,Me),i.framebufferRenderbuffer(i.FRAMEBUFFER,ce,i.RENDERBUFFER,Me)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),st(w.__webglDepthbuffer,P,!1);else{let ce=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Me=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,Me),i.framebufferRenderbuffer(i.FRAMEBUFFER,ce,i.RENDERBUFFER,Me)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function pt(P,w,$){let fe=n.get(P);w!==void 0&&Le(fe.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),$!==void 0&&yt(P)}function xt(P){let w=P.texture,$=n.get(P),fe=n.get(w);P.addEventListener("dispose",U),O(P);let ce=P.textures,Me=P.isWebGLCubeRenderTarget===!0,Ee=ce.length>1;if(Ee||(fe.__webglTexture===void 0&&(fe.__webglTexture=i.createTexture()),fe.__version=w.version,o.memory.textures++),Me){$.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(w.mipmaps.length>0){$.__webglFramebuffer[ne]=[];for(let se=0;se<w.mipmaps.length;se++)$.__webglFramebuffer[ne][se]=i.createFramebuffer()}else $.__webglFramebuffer[ne]=i.createFramebuffer()}else{if(w.mipmaps.length>0){$.__webglFramebuffer=[];for(let ne=0;ne<w.mipmaps.length;ne++)$.__webglFramebuffer[ne]=i.createFramebuffer()}else $.__webglFramebuffer=i.createFramebuffer();if(Ee)for(let ne=0,se=ce.length;ne<se;ne++){let ge=n.get(ce[ne]);ge.__webglTexture===void 0&&(ge.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&we(P)===!1){$.__webglMultisampledFramebuffer=i.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let ne=0;ne<ce.length;ne++){let se=ce[ne];$.__webglColorRenderbuffer[ne]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,$.__webglColorRenderbuffer[ne]);let ge=r.convert(se.format,se.colorSpace),V=r.convert(se.type),oe=T(se.internalFormat,ge,V,se.normalized,se.colorSpace,P.isXRRenderTarget===!0),ie=dt(P);i.renderbufferStorageMultisample(i.RENDERBUFFER,ie,oe,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ne,i.RENDERBUFFER,$.__webglColorRenderbuffer[ne])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&($.__webglDepthRenderbuffer=i.createRenderbuffer(),st($.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(Me){t.bindTexture(i.TEXTURE_CUBE_MAP,fe.__webglTexture),at(i.TEXTURE_CUBE_MAP,w);for(let ne=0;ne<6;ne++)if(w.mipmaps.length>0)for(let se=0;se<w.mipmaps.length;se++)Le($.__webglFramebuffer[ne][se],P,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,se);else Le($.__webglFramebuffer[ne],P,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);M(w)?_(i.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(Ee){for(let ne=0,se=ce.length;ne<se;ne++){let ge=ce[ne],V=n.get(ge),oe=i.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(oe=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(oe,V.__webglTexture),at(oe,ge),Le($.__webglFramebuffer,P,ge,i.COLOR_ATTACHMENT0+ne,oe,0),M(ge)&&_(oe)}t.unbindTexture()}else{let ne=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(ne=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ne,fe.__webglTexture),at(ne,w),w.mipmaps.length>0)for(let se=0;se<w.mipmaps.length;se++)Le($.__webglFramebuffer[se],P,w,i.COLOR_ATTACHMENT0,ne,se);else Le($.__webglFramebuffer,P,w,i.COLOR_ATTACHMENT0,ne,0);M(w)?_(ne):w.mipmaps.length>0&&i.texParameteri(ne,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&yt(P)}function B(P){let w=P.textures;for(let $=0,fe=w.length;$<fe;$++){let ce=w[$];if(M(ce)&&ce.mipmapsAutoUpdate===!0){let Me=E(P),Ee=n.get(ce).__webglTexture;t.bindTexture(Me,Ee),_(Me),t.unbindTexture()}}}let be=[];function qe(P){if(P.samples>0){if(we(P)===!1){let w=P.textures,$=P.width,fe=P.height,ce=i.COLOR_BUFFER_BIT,Me=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Ee=n.get(P),ne=w.length>1;if(ne)for(let ge=0;ge<w.length;ge++)t.bindFramebuffer(i.FRAMEBUFFER,Ee.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ge,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Ee.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ge,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Ee.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ee.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ee.__webglFramebuffer);for(let ge=0;ge<w.length;ge++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(ce|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(ce|=i.STENCIL_BUFFER_BIT)),ne){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Ee.__webglColorRenderbuffer[ge]);let V=n.get(w[ge]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,V,0)}i.blitFramebuffer(0,0,$,fe,0,0,$,fe,ce,i.NEAREST),l===!0&&(be.length=0,be.push(i.COLOR_ATTACHMENT0+ge),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&be.push(Me),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,be))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ne)for(let ge=0;ge<w.length;ge++){t.bindFramebuffer(i.FRAMEBUFFER,Ee.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ge,i.RENDERBUFFER,Ee.__webglColorRenderbuffer[ge]);let V=n.get(w[ge]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Ee.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ge,i.TEXTURE_2D,V,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ee.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let w=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function dt(P){return Math.min(s.maxSamples,P.samples)}function we(P){let w=n.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Ot(P){let w=o.render.frame;h.get(P)!==w&&(h.set(P,w),P.update())}function Je(P,w){let $=P.colorSpace,fe=P.format,ce=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||$!==Ba&&$!==Vs&&(Rt.getTransfer($)===Bt?(fe!==bi||ce!==ii)&&it("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ut("WebGLTextures: Unsupported texture color space:",$)),w}function nt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=re,this.resetTextureUnits=ee,this.getTextureUnits=J,this.setTextureUnits=ae,this.setTexture2D=pe,this.setTexture2DArray=ye,this.setTexture3D=Ae,this.setTextureCube=Se,this.rebindTextures=pt,this.setupRenderTarget=xt,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=qe,this.setupDepthRenderbuffer=yt,this.setupFrameBufferTexture=Le,this.useMultisampledRTT=we,this.dispose=G}function sC(i,e){function t(n,s=Vs){let r,o=Rt.getTransfer(s);if(n===ii)return i.UNSIGNED_BYTE;if(n===Ch)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Rh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===jf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Qf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Kf)return i.BYTE;if(n===Zf)return i.SHORT;if(n===jo)return i.UNSIGNED_SHORT;if(n===Ah)return i.INT;if(n===Hi)return i.UNSIGNED_INT;if(n===Wi)return i.FLOAT;if(n===Xi)return i.HALF_FLOAT;if(n===ep)return i.ALPHA;if(n===tp)return i.RGB;if(n===bi)return i.RGBA;if(n===Ds)return i.DEPTH_COMPONENT;if(n===zs)return i.DEPTH_STENCIL;if(n===np)return i.RED;if(n===Ph)return i.RED_INTEGER;if(n===pr)return i.RG;if(n===Ih)return i.RG_INTEGER;if(n===Lh)return i.RGBA_INTEGER;if(n===cl||n===hl||n===ul||n===dl)if(o===Bt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===cl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===hl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===ul)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===dl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===cl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===hl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===ul)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===dl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Nh||n===Dh||n===Fh||n===Uh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Nh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Dh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Fh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Uh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Oh||n===kh||n===Bh||n===zh||n===Vh||n===fl||n===Gh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Oh||n===kh)return o===Bt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Bh)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===zh)return r.COMPRESSED_R11_EAC;if(n===Vh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===fl)return r.COMPRESSED_RG11_EAC;if(n===Gh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Hh||n===Wh||n===Xh||n===qh||n===$h||n===Yh||n===Jh||n===Kh||n===Zh||n===jh||n===Qh||n===eu||n===tu||n===nu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Hh)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Wh)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Xh)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===qh)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===$h)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Yh)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Jh)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Kh)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Zh)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===jh)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Qh)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===eu)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===tu)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===nu)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===iu||n===su||n===ru)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===iu)return o===Bt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===su)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===ru)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===ou||n===au||n===pl||n===lu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===ou)return r.COMPRESSED_RED_RGTC1_EXT;if(n===au)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===pl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===lu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===zr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var rC=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,oC=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Sp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Ja(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Bn({vertexShader:rC,fragmentShader:oC,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new en(new ks(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},wp=class extends ds{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,m=null,y=typeof XRWebGLBinding<"u",p=new Sp,g={},v=t.getContextAttributes(),M=null,_=null,E=[],T=[],x=new Fe,S=null,O=null,L=new Qn;L.viewport=new on;let R=new Qn;R.viewport=new on;let U=[L,R],z=new Sh,I=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let pe=E[Q];return pe===void 0&&(pe=new ko,E[Q]=pe),pe.getTargetRaySpace()},this.getControllerGrip=function(Q){let pe=E[Q];return pe===void 0&&(pe=new ko,E[Q]=pe),pe.getGripSpace()},this.getHand=function(Q){let pe=E[Q];return pe===void 0&&(pe=new ko,E[Q]=pe),pe.getHandSpace()};function q(Q){let pe=T.indexOf(Q.inputSource);if(pe===-1)return;let ye=E[pe];ye!==void 0&&(ye.update(Q.inputSource,Q.frame,c||o),ye.dispatchEvent({type:Q.type,data:Q.inputSource}))}function H(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",he);for(let Q=0;Q<E.length;Q++){let pe=T[Q];pe!==null&&(T[Q]=null,E[Q].disconnect(pe))}I=null,G=null,p.reset();for(let Q in g)delete g[Q];if(e.setRenderTarget(M),f=null,d=null,u=null,s=null,_=null,re.stop(),n.isPresenting=!1,e.setPixelRatio(S),e.setSize(x.width,x.height,!1),O!==null){let Q=O.camera;Q.fov=O.fov,Q.zoom=O.zoom,Q.updateProjectionMatrix(),O=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&it("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&it("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",H),s.addEventListener("inputsourceschange",he),v.xrCompatible!==!0&&await t.makeXRCompatible(),S=e.getPixelRatio(),e.getSize(x),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ye=null,Ae=null,Se=null;v.depth&&(Se=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ye=v.stencil?zs:Ds,Ae=v.stencil?zr:Hi);let He={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(He),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),_=new ti(d.textureWidth,d.textureHeight,{format:bi,type:ii,depthTexture:new Os(d.textureWidth,d.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,ye),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ye={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ye),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),_=new ti(f.framebufferWidth,f.framebufferHeight,{format:bi,type:ii,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}_.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),re.setContext(s),re.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function he(Q){for(let pe=0;pe<Q.removed.length;pe++){let ye=Q.removed[pe],Ae=T.indexOf(ye);Ae>=0&&(T[Ae]=null,E[Ae].disconnect(ye))}for(let pe=0;pe<Q.added.length;pe++){let ye=Q.added[pe],Ae=T.indexOf(ye);if(Ae===-1){for(let He=0;He<E.length;He++)if(He>=T.length){T.push(ye),Ae=He;break}else if(T[He]===null){T[He]=ye,Ae=He;break}if(Ae===-1)break}let Se=E[Ae];Se&&Se.connect(ye)}}function Y(Q,pe){pe===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(pe.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let pe=Q.near,ye=Q.far;p.texture!==null&&(p.depthNear>0&&(pe=p.depthNear),p.depthFar>0&&(ye=p.depthFar)),z.near=R.near=L.near=pe,z.far=R.far=L.far=ye,(I!==z.near||G!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),I=z.near,G=z.far),z.layers.mask=Q.layers.mask|6,L.layers.mask=z.layers.mask&-5,R.layers.mask=z.layers.mask&-3;let Ae=Q.parent,Se=z.cameras;Y(z,Ae);for(let He=0;He<Se.length;He++)Y(Se[He],Ae);z.projectionMatrix.copy(L.projectionMatrix),z.projectionMatrixInverse.copy(L.projectionMatrixInverse),O===null&&Q.isPerspectiveCamera&&(O={camera:Q,fov:Q.fov,zoom:Q.zoom}),ee(Q,z,Ae)};function ee(Q,pe,ye){ye===null?Q.matrix.copy(pe.matrixWorld):(Q.matrix.copy(ye.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(pe.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(pe.projectionMatrix),Q.projectionMatrixInverse.copy(pe.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Yc*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Q){l=Q,d!==null&&(d.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(z)},this.getCameraTexture=function(Q){return g[Q]};let J=null;function ae(Q,pe){if(h=pe.getViewerPose(c||o),m=pe,h!==null){let ye=h.views;f!==null&&(e.setRenderTargetFramebuffer(_,f.framebuffer),e.setRenderTarget(_));let Ae=!1;ye.length!==z.cameras.length&&(z.cameras.length=0,Ae=!0);for(let Ze=0;Ze<ye.length;Ze++){let at=ye[Ze],rt=null;if(f!==null)rt=f.getViewport(at);else{let xe=u.getViewSubImage(d,at);rt=xe.viewport,Ze===0&&(e.setRenderTargetTextures(_,xe.colorTexture,xe.depthStencilTexture),e.setRenderTarget(_))}let le=U[Ze];le===void 0&&(le=new Qn,le.layers.enable(Ze),le.viewport=new on,U[Ze]=le),le.matrix.fromArray(at.transform.matrix),le.matrix.decompose(le.position,le.quaternion,le.scale),le.projectionMatrix.fromArray(at.projectionMatrix),le.projectionMatrixInverse.copy(le.projectionMatrix).invert(),le.viewport.set(rt.x,rt.y,rt.width,rt.height),Ze===0&&(z.matrix.copy(le.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Ae===!0&&z.cameras.push(le)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let Ze=u.getDepthInformation(ye[0]);Ze&&Ze.isValid&&Ze.texture&&p.init(Ze,s.renderState)}if(Se&&Se.includes("camera-access")&&y){e.state.unbindTexture(),u=n.getBinding();for(let Ze=0;Ze<ye.length;Ze++){let at=ye[Ze].camera;if(at){let rt=g[at];rt||(rt=new Ja,g[at]=rt);let le=u.getCameraImage(at);rt.sourceTexture=le}}}}for(let ye=0;ye<E.length;ye++){let Ae=T[ye],Se=E[ye];Ae!==null&&Se!==void 0&&Se.update(Ae,pe,c||o)}J&&J(Q,pe),pe.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:pe}),m=null}let re=new Hv;re.setAnimationLoop(ae),this.setAnimationLoop=function(Q){J=Q},this.dispose=function(){}}},aC=new Ht,Qv=new mt;Qv.set(-1,0,0,0,1,0,0,0,1);function lC(i,e){function t(p,g){p.matrixAutoUpdate===!0&&p.updateMatrix(),g.value.copy(p.matrix)}function n(p,g){g.color.getRGB(p.fogColor.value,up(i)),g.isFog?(p.fogNear.value=g.near,p.fogFar.value=g.far):g.isFogExp2&&(p.fogDensity.value=g.density)}function s(p,g,v,M,_){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(p,g):g.isMeshLambertMaterial?(r(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(p,g),u(p,g)):g.isMeshPhongMaterial?(r(p,g),h(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(p,g),d(p,g),g.isMeshPhysicalMaterial&&f(p,g,_)):g.isMeshMatcapMaterial?(r(p,g),m(p,g)):g.isMeshDepthMaterial?r(p,g):g.isMeshDistanceMaterial?(r(p,g),y(p,g)):g.isMeshNormalMaterial?r(p,g):g.isLineBasicMaterial?(o(p,g),g.isLineDashedMaterial&&a(p,g)):g.isPointsMaterial?l(p,g,v,M):g.isSpriteMaterial?c(p,g):g.isShadowMaterial?(p.color.value.copy(g.color),p.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(p,g){p.opacity.value=g.opacity,g.color&&p.diffuse.value.copy(g.color),g.emissive&&p.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(p.map.value=g.map,t(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,t(g.alphaMap,p.alphaMapTransform)),g.bumpMap&&(p.bumpMap.value=g.bumpMap,t(g.bumpMap,p.bumpMapTransform),p.bumpScale.value=g.bumpScale,g.side===ni&&(p.bumpScale.value*=-1)),g.normalMap&&(p.normalMap.value=g.normalMap,t(g.normalMap,p.normalMapTransform),p.normalScale.value.copy(g.normalScale),g.side===ni&&p.normalScale.value.negate()),g.displacementMap&&(p.displacementMap.value=g.displacementMap,t(g.displacementMap,p.displacementMapTransform),p.displacementScale.value=g.displacementScale,p.displacementBias.value=g.displacementBias),g.emissiveMap&&(p.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,p.emissiveMapTransform)),g.specularMap&&(p.specularMap.value=g.specularMap,t(g.specularMap,p.specularMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest);let v=e.get(g),M=v.envMap,_=v.envMapRotation;M&&(p.envMap.value=M,p.envMapRotation.value.setFromMatrix4(aC.makeRotationFromEuler(_)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Qv),p.reflectivity.value=g.reflectivity,p.ior.value=g.ior,p.refractionRatio.value=g.refractionRatio),g.lightMap&&(p.lightMap.value=g.lightMap,p.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,p.lightMapTransform)),g.aoMap&&(p.aoMap.value=g.aoMap,p.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,p.aoMapTransform))}function o(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,g.map&&(p.map.value=g.map,t(g.map,p.mapTransform))}function a(p,g){p.dashSize.value=g.dashSize,p.totalSize.value=g.dashSize+g.gapSize,p.scale.value=g.scale}function l(p,g,v,M){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.size.value=g.size*v,p.scale.value=M*.5,g.map&&(p.map.value=g.map,t(g.map,p.uvTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,t(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function c(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.rotation.value=g.rotation,g.map&&(p.map.value=g.map,t(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,t(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function h(p,g){p.specular.value.copy(g.specular),p.shininess.value=Math.max(g.shininess,1e-4)}function u(p,g){g.gradientMap&&(p.gradientMap.value=g.gradientMap)}function d(p,g){p.metalness.value=g.metalness,g.metalnessMap&&(p.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,p.metalnessMapTransform)),p.roughness.value=g.roughness,g.roughnessMap&&(p.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,p.roughnessMapTransform)),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)}function f(p,g,v){p.ior.value=g.ior,g.diffuseRoughness>0&&(p.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),g.sheen>0&&(p.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),p.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(p.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,p.sheenColorMapTransform)),g.sheenRoughnessMap&&(p.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,p.sheenRoughnessMapTransform))),g.clearcoat>0&&(p.clearcoat.value=g.clearcoat,p.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(p.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,p.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(p.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ni&&p.clearcoatNormalScale.value.negate())),g.dispersion>0&&(p.dispersion.value=g.dispersion),g.retroreflectivity>0&&(p.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(p.iridescence.value=g.iridescence,p.iridescenceIOR.value=g.iridescenceIOR,p.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(p.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,p.iridescenceMapTransform)),g.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),g.transmission>0&&(p.transmission.value=g.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(p.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,p.transmissionMapTransform)),p.thickness.value=g.thickness,g.thicknessMap&&(p.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=g.attenuationDistance,p.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(p.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(p.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=g.specularIntensity,p.specularColor.value.copy(g.specularColor),g.specularColorMap&&(p.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,p.specularColorMapTransform)),g.specularIntensityMap&&(p.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,p.specularIntensityMapTransform))}function m(p,g){g.matcap&&(p.matcap.value=g.matcap)}function y(p,g){let v=e.get(g).light;p.referencePosition.value.setFromMatrixPosition(v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function cC(i,e,t,n){let s={},r={};function o(v,M){let _=M.program;n.uniformBlockBinding(v,_,s[v.id])}function a(v,M){let _=s[v.id];_===void 0&&(m(v),_=l(v),s[v.id]=_,v.addEventListener("dispose",p));let E=M.program;n.updateUBOMapping(v,E);let T=e.render.frame;r[v.id]!==T&&(c(v),r[v.id]=T)}function l(v){let M=i.createBuffer(),_=v.__size,E=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,_,E),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(v){let M=s[v.id],_=v.uniforms,E=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let T=0,x=_.length;T<x;T++){let S=_[T];if(Array.isArray(S))for(let O=0,L=S.length;O<L;O++)h(S[O],T,O,E);else h(S,T,0,E)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,M,_,E){if(d(v,M,_,E)===!0){let T=v.__offset,x=v.value;if(Array.isArray(x)){let S=0;for(let O=0;O<x.length;O++){let L=x[O],R=y(L,!0);u(L,v.__data,S),S+=R.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,T,v.__data)}}function u(v,M,_){typeof v=="number"||typeof v=="boolean"?M[_]=v:v.isMatrix3?(M[_]=v.elements[0],M[_+1]=v.elements[1],M[_+2]=v.elements[2],M[_+3]=0,M[_+4]=v.elements[3],M[_+5]=v.elements[4],M[_+6]=v.elements[5],M[_+7]=0,M[_+8]=v.elements[6],M[_+9]=v.elements[7],M[_+10]=v.elements[8],M[_+11]=0):ArrayBuffer.isView(v)?M.set(v.subarray(0,M.length-_),_):v.toArray(M,_)}function d(v,M,_,E){let T=v.value,x=M+"_"+_;if(Array.isArray(T)){E[x]===void 0&&(E[x]=[]);let S=E[x],O=!1;for(let L=0;L<T.length;L++)f(T[L],S,L)===!0&&(O=!0);return O}return f(T,E,x)}function f(v,M,_){if(M[_]===void 0)return typeof v=="number"||typeof v=="boolean"?M[_]=v:ArrayBuffer.isView(v)?M[_]=v.slice():M[_]=v.clone(),!0;{let E=M[_];if(typeof v=="number"||typeof v=="boolean"){if(E!==v)return M[_]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(E.equals(v)===!1)return E.copy(v),!0}}return!1}function m(v){let M=v.uniforms,_=0,E=16;for(let x=0,S=M.length;x<S;x++){let O=Array.isArray(M[x])?M[x]:[M[x]];for(let L=0,R=O.length;L<R;L++){let U=O[L],z=Array.isArray(U.value)?U.value:[U.value],I=Array.isArray(M[x])||Array.isArray(U.value),G=_;for(let H=0,he=z.length;H<he;H++){let Y=z[H],ee=y(Y,I),J=_%E,ae=J%ee.boundary,re=J+ae;_+=ae,re!==0&&E-re<ee.storage&&(_+=E-re),H===0&&(G=_),_+=ee.storage}let q=U.type==="int"?Int32Array:U.type==="uint"?Uint32Array:Float32Array;U.__data=new q((_-G)/Float32Array.BYTES_PER_ELEMENT),U.__offset=G}}let T=_%E;return T>0&&(_+=E-T),v.__size=_,v.__cache={},this}function y(v,M){let _={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(_.boundary=4,_.storage=4):v.isVector2?(_.boundary=8,_.storage=8):v.isVector3||v.isColor?(_.boundary=16,_.storage=12):v.isVector4?(_.boundary=16,_.storage=16):v.isMatrix3?(_.boundary=16,_.storage=48):v.isMatrix4?(_.boundary=16,_.storage=64):v.isTexture?it("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(_.boundary=16,_.storage=v.byteLength):it("WebGLRenderer: Unsupported uniform value type.",v),M===!0&&(_.boundary=16,_.storage=Math.ceil(_.storage/16)*16),_}function p(v){let M=v.target;M.removeEventListener("dispose",p),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function g(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:g}}var hC=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ys=null;function uC(){return ys===null&&(ys=new Bo(hC,16,16,pr,Xi),ys.name="DFG_LUT",ys.minFilter=An,ys.magFilter=An,ys.wrapS=us,ys.wrapT=us,ys.generateMipmaps=!1,ys.needsUpdate=!0),ys}var fu=class{constructor(e={}){let{canvas:t=cv(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ii}=e;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let y=f,p=new Set([Lh,Ih,Ph]),g=new Set([ii,Hi,jo,zr,Ch,Rh]),v=new Uint32Array(4),M=new Int32Array(4),_={textures:[],min:[],max:[],resolution:[]},E=null,T=null,x=[],S=[],O=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=gs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,R=!1,U=null,z=null,I=null,G=null;this._outputColorSpace=gi;let q=0,H=0,he=null,Y=-1,ee=null,J=new on,ae=new on,re=null,Q=new Pt(0),pe=0,ye=t.width,Ae=t.height,Se=1,He=null,ot=null,Ze=new on(0,0,ye,Ae),at=new on(0,0,ye,Ae),rt=!1,le=new Nr,xe=new Qc,ve=!1,Be=!1,Le=new Ht,st=new F,ze=new on,yt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},pt=!1;function xt(){return he===null?Se:1}let B=n;function be(C,W){return t.getContext(C,W)}let qe,dt,we,Ot,Je,nt,P,w,$,fe,ce,Me,Ee,ne,se,ge,V,oe,ie,Re,_e,Ce,Qe;try{let C={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",$e,!1),t.addEventListener("webglcontextrestored",ht,!1),t.addEventListener("webglcontextcreationerror",Ne,!1),B===null){let W="webgl2";if(B=be(W,C),B===null)throw be(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ct()}catch(C){throw t.removeEventListener("webglcontextlost",$e,!1),t.removeEventListener("webglcontextrestored",ht,!1),t.removeEventListener("webglcontextcreationerror",Ne,!1),ut("WebGLRenderer: "+C.message),C}function ct(){qe=new MT(B),qe.init(),_e=new sC(B,qe),dt=new uT(B,qe,e,_e),we=new nC(B,qe),dt.reversedDepthBuffer&&d&&we.buffers.depth.setReversed(!0),z=B.createFramebuffer(),I=B.createFramebuffer(),G=B.createFramebuffer(),Ot=new ET(B),Je=new GA,nt=new iC(B,qe,we,Je,dt,_e,Ot),P=new bT(L),w=new Aw(B),Ce=new cT(B,w),$=new ST(B,w,Ot,Ce),fe=new AT(B,$,w,Ce,Ot),oe=new TT(B,dt,nt),se=new dT(Je),ce=new VA(L,P,qe,dt,Ce,se),Me=new lC(L,Je),Ee=new WA,ne=new KA(qe),V=new lT(L,P,we,fe,m,l),ge=new tC(L,fe,dt),Qe=new cC(B,Ot,dt,we),ie=new hT(B,qe,Ot),Re=new wT(B,qe,Ot),Ot.programs=ce.programs,L.capabilities=dt,L.extensions=qe,L.properties=Je,L.renderLists=Ee,L.shadowMap=ge,L.state=we,L.info=Ot}y!==ii&&(O=new RT(y,t.width,t.height,a,s,r));let de=new wp(L,B);this.xr=de,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let C=qe.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=qe.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(C){C!==void 0&&(Se=C,this.setSize(ye,Ae,!1))},this.getSize=function(C){return C.set(ye,Ae)},this.setSize=function(C,W,te=!0){if(de.isPresenting){it("WebGLRenderer: Can't change size while VR device is presenting.");return}ye=C,Ae=W,t.width=Math.floor(C*Se),t.height=Math.floor(W*Se),te===!0&&(t.style.width=C+"px",t.style.height=W+"px"),O!==null&&O.setSize(t.width,t.height),this.setViewport(0,0,C,W)},this.getDrawingBufferSize=function(C){return C.set(ye*Se,Ae*Se).floor()},this.setDrawingBufferSize=function(C,W,te){ye=C,Ae=W,Se=te,t.width=Math.floor(C*te),t.height=Math.floor(W*te),this.setViewport(0,0,C,W)},this.setEffects=function(C){if(y===ii){ut("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let W=0;W<C.length;W++)if(C[W].isOutputPass===!0){it("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(J)},this.getViewport=function(C){return C.copy(Ze)},this.setViewport=function(C,W,te,K){C.isVector4?Ze.set(C.x,C.y,C.z,C.w):Ze.set(C,W,te,K),we.viewport(J.copy(Ze).multiplyScalar(xt()).round())},this.getScissor=function(C){return C.copy(at)},this.setScissor=function(C,W,te,K){C.isVector4?at.set(C.x,C.y,C.z,C.w):at.set(C,W,te,K),we.scissor(ae.copy(at).multiplyScalar(xt()).round())},this.getScissorTest=function(){return rt},this.setScissorTest=function(C){we.setScissorTest(rt=C)},this.setOpaqueSort=function(C){He=C},this.setTransparentSort=function(C){ot=C},this.getClearColor=function(C){return C.copy(V.getClearColor())},this.setClearColor=function(){V.setClearColor(...arguments)},this.getClearAlpha=function(){return V.getClearAlpha()},this.setClearAlpha=function(){V.setClearAlpha(...arguments)},this.clear=function(C=!0,W=!0,te=!0){let K=0;if(C){let Z=!1;if(he!==null){let Pe=he.texture.format;Z=p.has(Pe)}if(Z){let Pe=he.texture.type,De=g.has(Pe),Ie=V.getClearColor(),Ue=V.getClearAlpha(),Ke=Ie.r,ft=Ie.g,St=Ie.b;De?(v[0]=Ke,v[1]=ft,v[2]=St,v[3]=Ue,B.clearBufferuiv(B.COLOR,0,v)):(M[0]=Ke,M[1]=ft,M[2]=St,M[3]=Ue,B.clearBufferiv(B.COLOR,0,M))}else K|=B.COLOR_BUFFER_BIT}W&&(K|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),te&&(K|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&B.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),U=C},this.dispose=function(){t.removeEventListener("webglcontextlost",$e,!1),t.removeEventListener("webglcontextrestored",ht,!1),t.removeEventListener("webglcontextcreationerror",Ne,!1),V.dispose(),Ee.dispose(),ne.dispose(),nt.dispose(),Je.dispose(),P.dispose(),fe.dispose(),$.dispose(),Ce.dispose(),Qe.dispose(),ce.dispose(),de.dispose(),de.removeEventListener("sessionstart",wl),de.removeEventListener("sessionend",$i),xs.stop()};function $e(C){C.preventDefault(),lp("WebGLRenderer: Context Lost."),R=!0}function ht(){lp("WebGLRenderer: Context Restored."),R=!1;let C=Ot.autoReset,W=ge.enabled,te=ge.autoUpdate,K=ge.needsUpdate,Z=ge.type;ct(),Ot.autoReset=C,ge.enabled=W,ge.autoUpdate=te,ge.needsUpdate=K,ge.type=Z}function Ne(C){ut("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function vt(C){let W=C.target;W.removeEventListener("dispose",vt),Yt(W)}function Yt(C){qn(C),Je.remove(C)}function qn(C){let W=Je.get(C).programs;W!==void 0&&(W.forEach(function(te){ce.releaseProgram(te)}),C.isShaderMaterial&&ce.releaseShaderCache(C))}this.renderBufferDirect=function(C,W,te,K,Z,Pe){W===null&&(W=yt);let De=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ie=da(C,W,te,K,Z);we.setMaterial(K,De);let Ue=te.index,Ke=1;if(K.wireframe===!0){if(Ue=$.getWireframeAttribute(te),Ue===void 0)return;Ke=2}let ft=te.drawRange,St=te.attributes.position,Ye=ft.start*Ke,wt=(ft.start+ft.count)*Ke;Pe!==null&&(Ye=Math.max(Ye,Pe.start*Ke),wt=Math.min(wt,(Pe.start+Pe.count)*Ke)),Ue!==null?(Ye=Math.max(Ye,0),wt=Math.min(wt,Ue.count)):St!=null&&(Ye=Math.max(Ye,0),wt=Math.min(wt,St.count));let sn=wt-Ye;if(sn<0||sn===1/0)return;Ce.setup(Z,K,Ie,te,Ue);let zt,Vt=ie;if(Ue!==null&&(zt=w.get(Ue),Vt=Re,Vt.setIndex(zt)),Z.isMesh)K.wireframe===!0?(we.setLineWidth(K.wireframeLinewidth*xt()),Vt.setMode(B.LINES)):Vt.setMode(B.TRIANGLES);else if(Z.isLine){let Sn=K.linewidth;Sn===void 0&&(Sn=1),we.setLineWidth(Sn*xt()),Z.isLineSegments?Vt.setMode(B.LINES):Z.isLineLoop?Vt.setMode(B.LINE_LOOP):Vt.setMode(B.LINE_STRIP)}else Z.isPoints?Vt.setMode(B.POINTS):Z.isSprite&&Vt.setMode(B.TRIANGLES);if(Z.isBatchedMesh)if(qe.get("WEBGL_multi_draw"))Vt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let Sn=Z._multiDrawStarts,We=Z._multiDrawCounts,mn=Z._multiDrawCount,At=Ue?w.get(Ue).bytesPerElement:1,bs=Je.get(K).currentProgram.getUniforms();for(let gn=0;gn<mn;gn++)bs.setValue(B,"_gl_DrawID",gn),Vt.render(Sn[gn]/At,We[gn])}else if(Z.isInstancedMesh)Vt.renderInstances(Ye,sn,Z.count);else if(te.isInstancedBufferGeometry){let Sn=te._maxInstanceCount!==void 0?te._maxInstanceCount:1/0,We=Math.min(te.instanceCount,Sn);Vt.renderInstances(Ye,sn,We)}else Vt.render(Ye,sn)};function ca(C,W,te,K){U!==null&&C.isNodeMaterial&&U.setObject(K,C),ve===!0&&se.setState(C,te,!1),C.transparent===!0&&C.side===ms&&C.forceSinglePass===!1?(C.side=ni,C.needsUpdate=!0,Yi(C,W,K),C.side=fr,C.needsUpdate=!0,Yi(C,W,K),C.side=ms):Yi(C,W,K)}this.compile=function(C,W,te=null){te===null&&(te=C),U!==null&&U.renderStart(C,W,te),T=ne.get(te),T.init(W),S.push(T),te.traverseVisible(function(Z){Z.isLight&&Z.layers.test(W.layers)&&(T.pushLight(Z),Z.castShadow&&T.pushShadow(Z))}),C!==te&&C.traverseVisible(function(Z){Z.isLight&&Z.layers.test(W.layers)&&(T.pushLight(Z),Z.castShadow&&T.pushShadow(Z))}),T.setupLights(),U!==null&&U.updateLights(T.state.lightsArray),Be=this.localClippingEnabled,ve=se.init(this.clippingPlanes,Be),ve===!0&&se.setGlobalState(this.clippingPlanes,W),U!==null&&ge.render(T.state.shadowsArray,te,W);let K=new Set;return C.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Pe=Z.material;if(Pe)if(Array.isArray(Pe))for(let De=0;De<Pe.length;De++){let Ie=Pe[De];ca(Ie,te,W,Z),K.add(Ie)}else ca(Pe,te,W,Z),K.add(Pe)}),T=S.pop(),U!==null&&U.renderEnd(),K},this.compileAsync=function(C,W,te=null){let K=this.compile(C,W,te);return new Promise(Z=>{function Pe(){if(K.forEach(function(De){let Ue=Je.get(De).currentProgram;(Ue===void 0||Ue.isReady())&&K.delete(De)}),K.size===0){Z(C);return}setTimeout(Pe,10)}qe.get("KHR_parallel_shader_compile")!==null?Pe():setTimeout(Pe,10)})};let Hr=null;function zu(C){Hr&&Hr(C)}function wl(){xs.stop()}function $i(){xs.start()}let xs=new Hv;xs.setAnimationLoop(zu),typeof self<"u"&&xs.setContext(self),this.setAnimationLoop=function(C){Hr=C,de.setAnimationLoop(C),C===null?xs.stop():xs.start()},de.addEventListener("sessionstart",wl),de.addEventListener("sessionend",$i),this.render=function(C,W){if(W!==void 0&&W.isCamera!==!0){ut("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(R===!0)return;U!==null&&U.renderStart(C,W);let te=de.enabled===!0&&de.isPresenting===!0,K=O!==null&&(he===null||te)&&O.begin(L,he);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),de.enabled===!0&&de.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(de.cameraAutoUpdate===!0&&de.updateCamera(W),W=de.getCamera()),C.isScene===!0&&C.onBeforeRender(L,C,W,he),T=ne.get(C,S.length),T.init(W),T.state.textureUnits=nt.getTextureUnits(),S.push(T),Le.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?xe.setFromArrayCamera(W):le.setFromProjectionMatrix(Le,Pi,W.reversedDepth),Be=this.localClippingEnabled,ve=se.init(this.clippingPlanes,Be),E=Ee.get(C,x.length),E.init(),x.push(E),this.info.render.frame++,de.enabled===!0&&de.isPresenting===!0){let De=L.xr.getDepthSensingMesh();De!==null&&_s(De,W,-1/0,L.sortObjects)}_s(C,W,0,L.sortObjects),E.finish(),U!==null&&U.updateLights(T.state.lightsArray),L.sortObjects===!0&&E.sort(He,ot),pt=de.enabled===!1||de.isPresenting===!1||de.hasDepthSensing()===!1,pt&&V.addToRenderList(E,C),this.info.autoReset===!0&&this.info.reset(),ve===!0&&se.beginShadows();let Z=T.state.shadowsArray;if(ge.render(Z,C,W),ve===!0&&se.endShadows(),(K&&O.hasRenderPass())===!1){let De=E.opaque,Ie=E.transmissive;if(T.setupLights(),W.isArrayCamera){let Ue=W.cameras;if(Ie.length>0)for(let Ke=0,ft=Ue.length;Ke<ft;Ke++){let St=Ue[Ke];Li(De,Ie,C,St)}pt&&V.render(C);for(let Ke=0,ft=Ue.length;Ke<ft;Ke++){let St=Ue[Ke];ha(E,C,St,St.viewport)}}else Ie.length>0&&Li(De,Ie,C,W),pt&&V.render(C),ha(E,C,W)}he!==null&&H===0&&(nt.updateMultisampleRenderTarget(he),nt.updateRenderTargetMipmap(he)),K&&O.end(L),C.isScene===!0&&C.onAfterRender(L,C,W),Ce.resetDefaultState(),Y=-1,ee=null,S.pop(),S.length>0?(T=S[S.length-1],nt.setTextureUnits(T.state.textureUnits),ve===!0&&se.setGlobalState(L.clippingPlanes,T.state.camera)):T=null,x.pop(),x.length>0?E=x[x.length-1]:E=null,U!==null&&U.renderEnd()};function _s(C,W,te,K){if(C.visible===!1)return;if(C.layers.test(W.layers)){if(C.isGroup)te=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(W);else if(C.isLight)T.pushLight(C),C.castShadow&&T.pushShadow(C);else if(C.isSprite){let De=W.isArrayCamera?xe:le;if(!C.frustumCulled||C.intersectsFrustum(De)){K&&ze.setFromMatrixPosition(C.matrixWorld).applyMatrix4(Le);let Ie=fe.update(C),Ue=C.material;Ue.visible&&E.push(C,Ie,Ue,te,ze.z,null,W)}}else if(C.isMesh||C.isLine||C.isPoints){let De=W.isArrayCamera?xe:le;if(!C.frustumCulled||C.intersectsFrustum(De)){let Ie=fe.update(C),Ue=C.material;if(K&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),ze.copy(C.boundingSphere.center)):(Ie.boundingSphere===null&&Ie.computeBoundingSphere(),ze.copy(Ie.boundingSphere.center)),ze.applyMatrix4(C.matrixWorld).applyMatrix4(Le)),Array.isArray(Ue)){let Ke=Ie.groups;for(let ft=0,St=Ke.length;ft<St;ft++){let Ye=Ke[ft],wt=Ue[Ye.materialIndex];wt&&wt.visible&&E.push(C,Ie,wt,te,ze.z,Ye,W)}}else Ue.visible&&E.push(C,Ie,Ue,te,ze.z,null,W)}}}let Pe=C.children;for(let De=0,Ie=Pe.length;De<Ie;De++)_s(Pe[De],W,te,K)}function ha(C,W,te,K){let{opaque:Z,transmissive:Pe,transparent:De}=C;T.setupLightsView(te),ve===!0&&se.setGlobalState(L.clippingPlanes,te),K&&we.viewport(J.copy(K)),Z.length>0&&an(Z,W,te),Pe.length>0&&an(Pe,W,te),De.length>0&&an(De,W,te),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Li(C,W,te,K){if((te.isScene===!0?te.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[K.id]===void 0){let Ye=qe.has("EXT_color_buffer_half_float")||qe.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[K.id]=new ti(1,1,{generateMipmaps:!0,type:Ye?Xi:ii,minFilter:_i,samples:Math.max(4,dt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Rt.workingColorSpace})}let Pe=T.state.transmissionRenderTarget[K.id],De=K.viewport||J;Pe.setSize(De.z*L.transmissionResolutionScale,De.w*L.transmissionResolutionScale);let Ie=L.getRenderTarget(),Ue=L.getActiveCubeFace(),Ke=L.getActiveMipmapLevel();L.setRenderTarget(Pe),L.getClearColor(Q),pe=L.getClearAlpha(),pe<1&&L.setClearColor(16777215,.5),L.clear(),pt&&V.render(te);let ft=L.toneMapping;L.toneMapping=gs;let St=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),T.setupLightsView(K),ve===!0&&se.setGlobalState(L.clippingPlanes,K),an(C,te,K),nt.updateMultisampleRenderTarget(Pe),nt.updateRenderTargetMipmap(Pe),qe.has("WEBGL_multisampled_render_to_texture")===!1){let Ye=!1;for(let wt=0,sn=W.length;wt<sn;wt++){let zt=W[wt],{object:Vt,geometry:Sn,material:We,group:mn}=zt;if(We.side===ms&&Vt.layers.test(K.layers)){let At=We.side;We.side=ni,We.needsUpdate=!0,un(Vt,te,K,Sn,We,mn),We.side=At,We.needsUpdate=!0,Ye=!0}}Ye===!0&&(nt.updateMultisampleRenderTarget(Pe),nt.updateRenderTargetMipmap(Pe))}L.setRenderTarget(Ie,Ue,Ke),L.setClearColor(Q,pe),St!==void 0&&(K.viewport=St),L.toneMapping=ft}function an(C,W,te){let K=W.isScene===!0?W.overrideMaterial:null;for(let Z=0,Pe=C.length;Z<Pe;Z++){let De=C[Z],{object:Ie,geometry:Ue,group:Ke}=De,ft=De.material;ft.allowOverride===!0&&K!==null&&(ft=K),Ie.layers.test(te.layers)&&un(Ie,W,te,Ue,ft,Ke)}}function un(C,W,te,K,Z,Pe){U!==null&&Z.isNodeMaterial&&U.setObject(C,Z),C.onBeforeRender(L,W,te,K,Z,Pe),C.modelViewMatrix.multiplyMatrices(te.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),Z.onBeforeRender(L,W,te,K,C,Pe),Z.transparent===!0&&Z.side===ms&&Z.forceSinglePass===!1?(Z.side=ni,Z.needsUpdate=!0,L.renderBufferDirect(te,W,K,Z,C,Pe),Z.side=fr,Z.needsUpdate=!0,L.renderBufferDirect(te,W,K,Z,C,Pe),Z.side=ms):L.renderBufferDirect(te,W,K,Z,C,Pe),C.onAfterRender(L,W,te,K,Z,Pe)}function dn(C){let W=0;for(let te of C)te.texture!==null&&W++;return W}function Yi(C,W,te){W.isScene!==!0&&(W=yt);let K=Je.get(C),Z=T.state.lights,Pe=T.state.shadowsArray,De=Z.state.version,Ie=ce.getParameters(C,Z.state,Pe,W,te,T.state.lightProbeGridArray),Ue=ce.getProgramCacheKey(Ie),Ke=K.programs;K.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?W.environment:null,K.fog=W.fog;let ft=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;K.envMap=P.get(C.envMap||K.environment,ft),K.envMapRotation=K.environment!==null&&C.envMap===null?W.environmentRotation:C.envMapRotation,Ke===void 0&&(C.addEventListener("dispose",vt),Ke=new Map,K.programs=Ke,K.programVariants=new Map);let St=Ke.get(Ue);if(St!==void 0){if(K.currentProgram===St&&K.lightsStateVersion===De)return ua(C,Ie),St}else Ie.uniforms=ce.getUniforms(C),U!==null&&C.isNodeMaterial&&U.build(C,te,Ie),C.onBeforeCompile(Ie,L),St=ce.acquireProgram(Ie,Ue),Ke.set(Ue,St),K.uniforms=Ie.uniforms;let Ye=K.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(Ye.clippingPlanes=se.uniform),ua(C,Ie),K.needsLights=Xs(C),K.lightsStateVersion=De,K.needsLights&&(Ye.ambientLightColor.value=Z.state.ambient,Ye.lightProbe.value=Z.state.probe,Ye.sunLights.value=Z.state.sun,Ye.sunLightShadows.value=Z.state.sunShadow,Ye.directionalLights.value=Z.state.directional,Ye.directionalLightShadows.value=Z.state.directionalShadow,Ye.spotLights.value=Z.state.spot,Ye.spotLightShadows.value=Z.state.spotShadow,Ye.rectAreaLights.value=Z.state.rectArea,Ye.ltc_1.value=Z.state.rectAreaLTC1,Ye.ltc_2.value=Z.state.rectAreaLTC2,Ye.pointLights.value=Z.state.point,Ye.pointLightShadows.value=Z.state.pointShadow,Ye.hemisphereLights.value=Z.state.hemi,Ye.sunShadowMatrix.value=Z.state.sunShadowMatrix,Ye.sunShadowCascade.value=Z.state.sunShadowCascade,Ye.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Ye.spotLightMatrix.value=Z.state.spotLightMatrix,Ye.spotLightMap.value=Z.state.spotLightMap,Ye.pointShadowMatrix.value=Z.state.pointShadowMatrix),K.numLightProbeGrids=dn(T.state.lightProbeGridArray),K.currentProgram=St,K.uniformsList=null,St}function oi(C,W,te,K,Z){let Pe=Je.get(C),De=Pe.currentProgram.id+","+K+","+Z,Ie=Pe.programVariants.get(De);return Ie===void 0?(Ie=Yi(C,W,te),Pe.programVariants.set(De,Ie)):(Pe.currentProgram=Ie,Pe.uniformsList=null,Pe.outputColorSpace=K,Pe.toneMapping=Z),Ie}function Ws(C){if(C.uniformsList===null){let W=C.currentProgram.getUniforms();C.uniformsList=ea.seqWithValue(W.seq,C.uniforms)}return C.uniformsList}function ua(C,W){let te=Je.get(C);te.outputColorSpace=W.outputColorSpace,te.batching=W.batching,te.batchingColor=W.batchingColor,te.instancing=W.instancing,te.instancingColor=W.instancingColor,te.instancingMorph=W.instancingMorph,te.skinning=W.skinning,te.morphTargets=W.morphTargets,te.morphNormals=W.morphNormals,te.morphColors=W.morphColors,te.morphTargetsCount=W.morphTargetsCount,te.numClippingPlanes=W.numClippingPlanes,te.numIntersection=W.numClipIntersection,te.vertexAlphas=W.vertexAlphas,te.vertexTangents=W.vertexTangents,te.toneMapping=W.toneMapping}function da(C,W,te,K,Z){W.isScene!==!0&&(W=yt),nt.resetTextureUnits();let Pe=W.fog,De=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?W.environment:null,Ie=he===null?L.outputColorSpace:he.isXRRenderTarget===!0?he.texture.colorSpace:Rt.workingColorSpace,Ue=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,Ke=P.get(K.envMap||De,Ue),ft=K.vertexColors===!0&&!!te.attributes.color&&te.attributes.color.itemSize===4,St=!!te.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),Ye=!!te.morphAttributes.position,wt=!!te.morphAttributes.normal,sn=!!te.morphAttributes.color,zt=gs;K.toneMapped&&(he===null||he.isXRRenderTarget===!0)&&(zt=L.toneMapping);let Vt=te.morphAttributes.position||te.morphAttributes.normal||te.morphAttributes.color,Sn=Vt!==void 0?Vt.length:0,We=Je.get(K),mn=T.state.lights;if(ve===!0&&(Be===!0||C!==ee)){let Gt=C===ee&&K.id===Y;se.setState(K,C,Gt)}let At=!1,bs=!1;K.version===We.__version?We.needsLights&&We.lightsStateVersion!==mn.state.version||Z.isBatchedMesh&&We.batching===!1||!Z.isBatchedMesh&&We.batching===!0||Z.isBatchedMesh&&We.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&We.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&We.instancing===!1||!Z.isInstancedMesh&&We.instancing===!0||Z.isSkinnedMesh&&We.skinning===!1||!Z.isSkinnedMesh&&We.skinning===!0||Z.isInstancedMesh&&We.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&We.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&We.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&We.instancingMorph===!1&&Z.morphTexture!==null||We.envMap!==Ke||K.fog===!0&&We.fog!==Pe||We.numClippingPlanes!==void 0&&(We.numClippingPlanes!==se.numPlanes||We.numIntersection!==se.numIntersection)||We.vertexAlphas!==ft||We.vertexTangents!==St||We.morphTargets!==Ye||We.morphNormals!==wt||We.morphColors!==sn||We.morphTargetsCount!==Sn||We.numLightProbeGrids!==dn(T.state.lightProbeGridArray)?At=!0:(We.outputColorSpace!==Ie||We.toneMapping!==zt)&&(bs=!0):(At=!0,We.__version=K.version);let gn=We.currentProgram;(At===!0||bs===!0)&&(gn=bs===!0?oi(K,W,Z,Ie,zt):Yi(K,W,Z),U&&K.isNodeMaterial&&U.onUpdateProgram(K,gn,We));let qr=!1,Ji=!1,Ms=!1,_t=gn.getUniforms(),ln=We.uniforms;if(we.useProgram(gn.program)&&(qr=!0,Ji=!0,Ms=!0),K.id!==Y&&(Y=K.id,Ji=!0),qr||ee!==C){we.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),_t.setValue(B,"projectionMatrix",C.projectionMatrix),_t.setValue(B,"viewMatrix",C.matrixWorldInverse);let yn=_t.map.cameraPosition;yn!==void 0&&yn.setValue(B,st.setFromMatrixPosition(C.matrixWorld)),dt.logarithmicDepthBuffer&&_t.setValue(B,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&_t.setValue(B,"isOrthographic",C.isOrthographicCamera===!0),ee!==C&&(ee=C,Ji=!0,Ms=!0)}if(We.needsLights&&(mn.state.sunShadowMap.length>0&&_t.setValue(B,"sunShadowMap",mn.state.sunShadowMap,nt),mn.state.directionalShadowMap.length>0&&_t.setValue(B,"directionalShadowMap",mn.state.directionalShadowMap,nt),mn.state.spotShadowMap.length>0&&_t.setValue(B,"spotShadowMap",mn.state.spotShadowMap,nt),mn.state.pointShadowMap.length>0&&_t.setValue(B,"pointShadowMap",mn.state.pointShadowMap,nt)),Z.isSkinnedMesh){_t.setOptional(B,Z,"bindMatrix"),_t.setOptional(B,Z,"bindMatrixInverse");let Gt=Z.skeleton;Gt&&(Gt.boneTexture===null&&Gt.computeBoneTexture(),_t.setValue(B,"boneTexture",Gt.boneTexture,nt))}Z.isBatchedMesh&&(_t.setOptional(B,Z,"batchingTexture"),_t.setValue(B,"batchingTexture",Z._matricesTexture,nt),_t.setOptional(B,Z,"batchingIdTexture"),_t.setValue(B,"batchingIdTexture",Z._indirectTexture,nt),_t.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&_t.setValue(B,"batchingColorTexture",Z._colorsTexture,nt));let $n=te.morphAttributes;if(($n.position!==void 0||$n.normal!==void 0||$n.color!==void 0)&&oe.update(Z,te,gn),(Ji||We.receiveShadow!==Z.receiveShadow)&&(We.receiveShadow=Z.receiveShadow,_t.setValue(B,"receiveShadow",Z.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&W.environment!==null&&(ln.envMapIntensity.value=W.environmentIntensity),ln.dfgLUT!==void 0&&(ln.dfgLUT.value=uC()),Ji){if(_t.setValue(B,"toneMappingExposure",L.toneMappingExposure),We.needsLights&&Wr(ln,Ms),Pe&&K.fog===!0&&Me.refreshFogUniforms(ln,Pe),Me.refreshMaterialUniforms(ln,K,Se,Ae,T.state.transmissionRenderTarget[C.id]),We.needsLights&&We.numLightProbeGrids>0){let Gt=_,yn=0;for(let zn of T.state.lightProbeGridArray)zn.texture!==null&&(Gt.textures[yn]=zn.texture,Gt.min[yn]=zn.boundingBox.min,Gt.max[yn]=zn.boundingBox.max,Gt.resolution[yn]=zn.resolution,yn++);for(let zn in Gt)Gt[zn].length=yn;ln.probesSH.value=Gt.textures,ln.probesMin.value=Gt.min,ln.probesMax.value=Gt.max,ln.probesResolution.value=Gt.resolution}ea.upload(B,Ws(We),ln,nt)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(ea.upload(B,Ws(We),ln,nt),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&_t.setValue(B,"center",Z.center),_t.setValue(B,"modelViewMatrix",Z.modelViewMatrix),_t.setValue(B,"normalMatrix",Z.normalMatrix),_t.setValue(B,"modelMatrix",Z.matrixWorld),K.uniformsGroups!==void 0){let Gt=K.uniformsGroups;for(let yn=0,zn=Gt.length;yn<zn;yn++){let El=Gt[yn];Qe.update(El,gn),Qe.bind(El,gn)}}return gn}function Wr(C,W){C.ambientLightColor.needsUpdate=W,C.lightProbe.needsUpdate=W,C.sunLights.needsUpdate=W,C.sunLightShadows.needsUpdate=W,C.directionalLights.needsUpdate=W,C.directionalLightShadows.needsUpdate=W,C.pointLights.needsUpdate=W,C.pointLightShadows.needsUpdate=W,C.spotLights.needsUpdate=W,C.spotLightShadows.needsUpdate=W,C.rectAreaLights.needsUpdate=W,C.hemisphereLights.needsUpdate=W}function Xs(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return he},this.setRenderTargetTextures=function(C,W,te){let K=Je.get(C);K.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Je.get(C.texture).__webglTexture=W,Je.get(C.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:te,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,W){let te=Je.get(C);te.__webglFramebuffer=W,te.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(C,W=0,te=0){he=C,q=W,H=te;let K=null,Z=!1,Pe=!1;if(C){let Ie=Je.get(C);if(Ie.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(B.FRAMEBUFFER,Ie.__webglFramebuffer),J.copy(C.viewport),ae.copy(C.scissor),re=C.scissorTest,we.viewport(J),we.scissor(ae),we.setScissorTest(re),Y=-1;return}else if(Ie.__webglFramebuffer===void 0)nt.setupRenderTarget(C);else if(Ie.__hasExternalTextures)nt.rebindTextures(C,Je.get(C.texture).__webglTexture,Je.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let ft=C.depthTexture;if(Ie.__boundDepthTexture!==ft){if(ft!==null&&Je.has(ft)&&(C.width!==ft.image.width||C.height!==ft.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");nt.setupDepthRenderbuffer(C)}}let Ue=C.texture;(Ue.isData3DTexture||Ue.isDataArrayTexture||Ue.isCompressedArrayTexture)&&(Pe=!0);let Ke=Je.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(Ke[W])?K=Ke[W][te]:K=Ke[W],Z=!0):C.samples>0&&nt.useMultisampledRTT(C)===!1?K=Je.get(C).__webglMultisampledFramebuffer:Array.isArray(Ke)?K=Ke[te]:K=Ke,J.copy(C.viewport),ae.copy(C.scissor),re=C.scissorTest}else J.copy(Ze).multiplyScalar(Se).floor(),ae.copy(at).multiplyScalar(Se).floor(),re=rt;if(te!==0&&(K=z),we.bindFramebuffer(B.FRAMEBUFFER,K)&&we.drawBuffers(C,K),we.viewport(J),we.scissor(ae),we.setScissorTest(re),Z){let Ie=Je.get(C.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+W,Ie.__webglTexture,te)}else if(Pe){let Ie=W;for(let Ue=0;Ue<C.textures.length;Ue++){let Ke=Je.get(C.textures[Ue]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ue,Ke.__webglTexture,te,Ie)}}else if(C!==null&&te!==0){let Ie=Je.get(C.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ie.__webglTexture,te)}Y=-1};function Xr(C){let W=Je.get(C);return(W.__readFormat!==C.format||W.__readType!==C.type)&&(W.__readFormat=C.format,W.__readType=C.type,W.__formatReadable=dt.textureFormatReadable(C.format),W.__typeReadable=dt.textureTypeReadable(C.type)),W}this.readRenderTargetPixels=function(C,W,te,K,Z,Pe,De,Ie=0){if(!(C&&C.isWebGLRenderTarget)){ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ue=Je.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&De!==void 0&&(Ue=Ue[De],Array.isArray(Ue)&&(Ue=Ue[0])),Ue){we.bindFramebuffer(B.FRAMEBUFFER,Ue);try{let Ke=C.textures[Ie],ft=Ke.format,St=Ke.type;C.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ie);let Ye=Xr(Ke);if(Ye.__formatReadable===!1){ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ye.__typeReadable===!1){ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=C.width-K&&te>=0&&te<=C.height-Z&&B.readPixels(W,te,K,Z,_e.convert(ft),_e.convert(St),Pe)}finally{let Ke=he!==null?Je.get(he).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,Ke)}}},this.readRenderTargetPixelsAsync=async function(C,W,te,K,Z,Pe,De,Ie=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ue=Je.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&De!==void 0&&(Ue=Ue[De],Array.isArray(Ue)&&(Ue=Ue[0])),Ue)if(W>=0&&W<=C.width-K&&te>=0&&te<=C.height-Z){we.bindFramebuffer(B.FRAMEBUFFER,Ue);let Ke=C.textures[Ie],ft=Ke.format,St=Ke.type;C.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ie);let Ye=Xr(Ke);if(Ye.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ye.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let wt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,wt),B.bufferData(B.PIXEL_PACK_BUFFER,Pe.byteLength,B.STREAM_READ),B.readPixels(W,te,K,Z,_e.convert(ft),_e.convert(St),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let sn=he!==null?Je.get(he).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,sn);let zt=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await uv(B,zt,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,wt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Pe),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(wt),B.deleteSync(zt),Pe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,W=null,te=0){let K=Math.pow(2,-te),Z=Math.floor(C.image.width*K),Pe=Math.floor(C.image.height*K),De=W!==null?W.x:0,Ie=W!==null?W.y:0;nt.setTexture2D(C,0),B.copyTexSubImage2D(B.TEXTURE_2D,te,0,0,De,Ie,Z,Pe),we.unbindTexture()},this.copyTextureToTexture=function(C,W,te=null,K=null,Z=0,Pe=0){let De,Ie,Ue,Ke,ft,St,Ye,wt,sn,zt=C.isCompressedTexture?C.mipmaps[Pe]:C.image;if(te!==null)De=te.max.x-te.min.x,Ie=te.max.y-te.min.y,Ue=te.isBox3?te.max.z-te.min.z:1,Ke=te.min.x,ft=te.min.y,St=te.isBox3?te.min.z:0;else{let _t=Math.pow(2,-Z);De=Math.floor(zt.width*_t),Ie=Math.floor(zt.height*_t),C.isDataArrayTexture?Ue=zt.depth:C.isData3DTexture?Ue=Math.floor(zt.depth*_t):Ue=1,Ke=0,ft=0,St=0}K!==null?(Ye=K.x,wt=K.y,sn=K.z):(Ye=0,wt=0,sn=0);let Vt=_e.convert(W.format),Sn=_e.convert(W.type),We;W.isData3DTexture?(nt.setTexture3D(W,0),We=B.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(nt.setTexture2DArray(W,0),We=B.TEXTURE_2D_ARRAY):(nt.setTexture2D(W,0),We=B.TEXTURE_2D),we.activeTexture(B.TEXTURE0),we.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,W.flipY),we.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),we.pixelStorei(B.UNPACK_ALIGNMENT,W.unpackAlignment);let mn=we.getParameter(B.UNPACK_ROW_LENGTH),At=we.getParameter(B.UNPACK_IMAGE_HEIGHT),bs=we.getParameter(B.UNPACK_SKIP_PIXELS),gn=we.getParameter(B.UNPACK_SKIP_ROWS),qr=we.getParameter(B.UNPACK_SKIP_IMAGES);we.pixelStorei(B.UNPACK_ROW_LENGTH,zt.width),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,zt.height),we.pixelStorei(B.UNPACK_SKIP_PIXELS,Ke),we.pixelStorei(B.UNPACK_SKIP_ROWS,ft),we.pixelStorei(B.UNPACK_SKIP_IMAGES,St);let Ji=C.isDataArrayTexture||C.isData3DTexture,Ms=W.isDataArrayTexture||W.isData3DTexture;if(C.isDepthTexture){let _t=Je.get(C),ln=Je.get(W),$n=Je.get(_t.__renderTarget),Gt=Je.get(ln.__renderTarget);we.bindFramebuffer(B.READ_FRAMEBUFFER,$n.__webglFramebuffer),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,Gt.__webglFramebuffer);for(let yn=0;yn<Ue;yn++)Ji&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Je.get(C).__webglTexture,Z,St+yn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Je.get(W).__webglTexture,Pe,sn+yn)),B.blitFramebuffer(Ke,ft,Ke+De,ft+Ie,Ye,wt,Ye+De,wt+Ie,B.DEPTH_BUFFER_BIT,B.NEAREST);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||C.isRenderTargetTexture||Je.has(C)){let _t=Je.get(C),ln=Je.get(W);we.bindFramebuffer(B.READ_FRAMEBUFFER,I),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,G);for(let $n=0;$n<Ue;$n++)Ji?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,_t.__webglTexture,Z,St+$n):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,_t.__webglTexture,Z),Ms?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ln.__webglTexture,Pe,sn+$n):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ln.__webglTexture,Pe),Z!==0?B.blitFramebuffer(Ke,ft,Ke+De,ft+Ie,Ye,wt,Ye+De,wt+Ie,B.COLOR_BUFFER_BIT,B.NEAREST):Ms?B.copyTexSubImage3D(We,Pe,Ye,wt,sn+$n,Ke,ft,De,Ie):B.copyTexSubImage2D(We,Pe,Ye,wt,Ke,ft,De,Ie);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else Ms?C.isDataTexture||C.isData3DTexture?B.texSubImage3D(We,Pe,Ye,wt,sn,De,Ie,Ue,Vt,Sn,zt.data):W.isCompressedArrayTexture?B.compressedTexSubImage3D(We,Pe,Ye,wt,sn,De,Ie,Ue,Vt,zt.data):B.texSubImage3D(We,Pe,Ye,wt,sn,De,Ie,Ue,Vt,Sn,zt):C.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Pe,Ye,wt,De,Ie,Vt,Sn,zt.data):C.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Pe,Ye,wt,zt.width,zt.height,Vt,zt.data):B.texSubImage2D(B.TEXTURE_2D,Pe,Ye,wt,De,Ie,Vt,Sn,zt);we.pixelStorei(B.UNPACK_ROW_LENGTH,mn),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,At),we.pixelStorei(B.UNPACK_SKIP_PIXELS,bs),we.pixelStorei(B.UNPACK_SKIP_ROWS,gn),we.pixelStorei(B.UNPACK_SKIP_IMAGES,qr),Pe===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&B.generateMipmap(We),we.unbindTexture()},this.initRenderTarget=function(C){Je.get(C).__webglFramebuffer===void 0&&nt.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?nt.setTextureCube(C,0):C.isData3DTexture?nt.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?nt.setTexture2DArray(C,0):nt.setTexture2D(C,0),we.unbindTexture()},this.resetState=function(){q=0,H=0,he=null,we.reset(),Ce.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Pi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Rt._getDrawingBufferColorSpace(e),t.unpackColorSpace=Rt._getUnpackColorSpace()}};var qi=new F,ex=new F,tx=new F,na=new F,nx=new Ht;function ia(i,e,t,n){let s=new F(2*(t-e.x)/e.width-1,1-2*(n-e.y)/e.height,.5).unproject(i);return new ps(i.position.clone(),s.sub(i.position).normalize())}function gu(i,e,t,n,s,r){let{shape:o,places:a}=i,l=(p,g)=>g.fromArray(a,3*p),c=ia(e,t,n,s),h=1/0,u=-1,d=new F,{triangles:f}=i;if(f){for(let p=0;p<f.length;p+=3){let[g,v,M]=[f[p],f[p+1],f[p+2]];if(!c.intersectTriangle(l(g,qi),l(v,ex),l(M,tx),!1,na))continue;let _=na.distanceToSquared(c.origin);if(_>=h)continue;h=_,d.copy(na);let[E,T,x]=[qi.distanceToSquared(na),ex.distanceToSquared(na),tx.distanceToSquared(na)];u=E<=T&&E<=x?g:T<=x?v:M}if(u>=0)return{point:o.point[u],place:l(u,new F),surface:d}}nx.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse);let m=r*r;for(let p=0;p<o.corners;p++){l(p,qi).applyMatrix4(nx);let g=t.x+(qi.x+1)/2*t.width-n,v=t.y+(1-qi.y)/2*t.height-s,M=g*g+v*v+40*qi.z;qi.z<1&&g*g+v*v<r*r&&M-40<m&&(m=M-40,u=p)}if(u<0)return null;let y=l(u,new F);return{point:o.point[u],place:y,surface:y.clone()}}function yu(i,e,t){return qi.copy(t).project(i),qi.z>1?null:{x:e.x+(qi.x+1)/2*e.width,y:e.y+(1-qi.y)/2*e.height}}var dC=30,Ep=14,fC=6,pC=.15,ix=.01,vu=class{constructor(e,t){this.picture=e;this.store=t;let{canvas:n}=e,s=(r,o,a,l=!0)=>{r.addEventListener(o,a,{passive:l}),this.ends.push(()=>r.removeEventListener(o,a))};s(n,"pointerdown",r=>this.down(r)),s(n,"pointermove",r=>this.move(r)),s(n,"pointerrawupdate",r=>this.raw(r)),s(n,"pointerup",r=>this.up(r)),s(n,"pointercancel",r=>this.up(r)),s(n,"pointerleave",()=>this.leave()),s(n,"wheel",r=>this.wheel(r),!1),s(n,"contextmenu",r=>r.preventDefault(),!1),s(n,"dblclick",r=>this.double(r)),s(window,"keydown",r=>this.key(r),!1),s(window,"blur",()=>this.release())}picture;store;pointers=new Map;doing=null;holder=-1;moved=0;over=null;ends=[];pads=new vo;dispose(){this.release();for(let e of this.ends)e()}release(){this.picture.hold.release(),this.doing==="hold"&&(this.doing=null),this.holder=-1,this.picture.draw()}step(e){let{hold:t,orbit:n}=this.picture,s=this.doing==="hold"&&this.moved<fC&&t.push(e,n.axes()[2]);this.over&&this.picture.hover(!t.holds&&this.picture.mayAct()?this.picture.pick(this.over.x,this.over.y,Ep):null);let r=this.pads.read();if(!r)return s;if(r.pressed&&!t.holds&&this.grabCentre(),r.released&&t.holds&&t.release(),t.holds&&Math.hypot(r.x,r.y,r.depth)>pC){let[o,a,l]=n.axes(),c=1.2*n.metres(this.picture.ownCell().height)*this.picture.ownCell().height*.5*e;t.shift(o.multiplyScalar(r.x*c).addScaledVector(a,-r.y*c).addScaledVector(l,r.depth*c)),s=!0}return this.pads.rumble(t.holds?this.picture.force():0),s||t.holds}at(e){let t=this.picture.canvas.getBoundingClientRect();return{x:e.clientX-t.left,y:e.clientY-t.top}}down(e){let{canvas:t,hold:n,orbit:s}=this.picture,r=this.at(e);if(t.setPointerCapture(e.pointerId),this.pointers.set(e.pointerId,r),this.moved=0,e.pointerType==="touch"&&this.pointers.size===2){this.doing==="hold"&&n.release(),this.doing="two";return}if(!(this.pointers.size>1)){if(e.button===1||e.button===0&&e.shiftKey)this.doing="pan";else if(e.button===2||e.ctrlKey)this.doing="turn";else{let o=this.picture.mayAct()?this.picture.pick(r.x,r.y,e.pointerType==="touch"?dC:Ep):null;this.doing=o?"hold":"turn",o&&(this.holder=e.pointerId,this.picture.take(o,s.axes()[2],e.timeStamp),this.picture.hover(null))}t.dataset.doing=this.doing,this.picture.draw()}}move(e){let t=this.at(e),{orbit:n}=this.picture,s=this.pointers.get(e.pointerId);if(!s){e.pointerType!=="touch"&&(this.over=t),this.picture.draw();return}let[r,o]=[t.x-s.x,t.y-s.y];this.moved+=Math.hypot(r,o);let a=this.picture.ownCell().height;if(this.doing==="two"&&this.pointers.size===2){let l=[...this.pointers].find(([h])=>h!==e.pointerId)[1],c=h=>Math.max(Math.hypot(h.x-l.x,h.y-l.y),10);n.zoom(c(s)/c(t)),n.turn(r/2,o/2)}else this.doing==="hold"&&e.pointerId===this.holder?this.lead(e,t,r,o):this.doing==="turn"?n.turn(r,o):this.doing==="pan"&&n.pan(r,o,a);this.pointers.set(e.pointerId,t),this.picture.draw()}raw(e){if(this.doing!=="hold"||e.pointerId!==this.holder||e.shiftKey)return;let t=this.at(e);this.picture.hold.follow(ia(this.picture.orbit.camera,this.picture.ownCell(),t.x,t.y),e.timeStamp)}lead(e,t,n,s){let{hold:r,orbit:o}=this.picture,a=ia(o.camera,this.picture.ownCell(),t.x,t.y);if(!e.shiftKey||r.action!=="pose")return r.follow(a,e.timeStamp);let[l,c]=o.axes();r.turn(c,ix*n,e.timeStamp),r.turn(l,ix*s,e.timeStamp),r.rebase(a)}up(e){this.pointers.delete(e.pointerId),this.doing==="hold"&&e.pointerId===this.holder&&(this.picture.hold.release(e.timeStamp),this.holder=-1,this.doing=null),this.doing==="two"&&this.pointers.size===1&&(this.doing="turn"),this.pointers.size||(this.doing=null),delete this.picture.canvas.dataset.doing,e.pointerType!=="touch"&&(this.over=this.at(e)),this.picture.draw()}leave(){this.over=null,this.picture.hover(null),this.picture.draw()}wheel(e){e.preventDefault();let{orbit:t,hold:n}=this.picture,{height:s}=this.picture.ownCell(),r=Math.max(-3,Math.min(3,(e.deltaY||e.deltaX)/(e.deltaMode?3:100)));e.shiftKey&&this.store.tool==="ball"?(n.radius=Math.min(Math.max(n.radius*.9**r,.2*.16*t.size),.8*t.size),n.action==="ball"&&n.send()):e.shiftKey&&this.store.tool==="blade"?n.deepen(.9**r):e.shiftKey&&n.action==="pose"?n.turn(t.axes()[2],-.15*r):n.holds?n.depth(-r*.06*t.metres(s)*s*.5,t.axes()[2]):t.zoom(1.12**r),this.picture.draw()}double(e){let t=this.at(e),{slot:n}=this.picture.cellAt(t.x,t.y);n!==this.store.slot&&this.store.scene?.own.includes(n)?this.store.take(n):this.picture.pick(t.x,t.y,Ep)||this.picture.orbit.reset(),this.picture.draw()}grabCentre(){let e=this.picture.ownCell();if(!this.picture.mayAct())return;let t=this.picture.pick(e.x+e.width/2,e.y+e.height/2,Math.max(e.width,e.height));if(!t)return;let n=this.store.tool==="grab"?{...t,surface:t.place}:t;this.picture.take(n,this.picture.orbit.axes()[2])}key(e){let{hold:t,orbit:n,canvas:s}=this.picture;if(!Tp(e)){if(e.key==="Escape"&&t.holds){this.release(),e.preventDefault();return}if(!(document.activeElement!==s&&document.activeElement!==document.body)){if(e.key==="g"||e.key==="G")t.holds?this.release():this.grabCentre();else if(e.key in sx){let[r,o]=sx[e.key];if(t.holds){let[a,l,c]=n.axes(),h=.05*n.size;t.shift(e.shiftKey?c.multiplyScalar(o*h):a.multiplyScalar(r*h).addScaledVector(l,o*h))}else n.turn(-40*r,40*o)}else if(e.key==="+"||e.key==="=")n.zoom(1/1.15);else if(e.key==="-")n.zoom(1.15);else if(e.key==="0"||e.key==="Home")n.reset();else return;e.preventDefault(),this.picture.draw()}}}},sx={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function Tp(i){let e=i.target;return i.defaultPrevented||i.ctrlKey||i.metaKey||i.altKey?!0:!!e?.closest?.("input, select, textarea, [contenteditable], dialog")}var xu=class{constructor(e,t){this.rails=e;this.connection=t;let{canvas:n}=e,s=(r,o,a)=>{r.addEventListener(o,a),this.ends.push(()=>r.removeEventListener(o,a))};s(n,"pointerdown",r=>this.down(r)),s(n,"pointermove",r=>this.move(r)),s(n,"pointerrawupdate",r=>{this.holds&&r.pointerId===this.finger&&this.follow(this.at(r).x,r.timeStamp)}),s(n,"pointerup",r=>this.up(r)),s(n,"pointercancel",r=>this.up(r)),s(n,"dblclick",r=>{let o=e.whose(this.at(r).y);o!==null&&e.take(o)}),s(window,"keydown",r=>this.key(r)),s(window,"blur",()=>this.release())}rails;connection;holds=!1;point=0;target=0;offset=0;finger=-1;pads=new vo;ends=[];dispose(){this.release();for(let e of this.ends)e()}release(e){this.holds&&(this.holds=!1,this.finger=-1,this.send(e),this.rails.draw())}send(e){this.connection.point({action:this.holds?"grab":"free",point:this.point,target:[this.target,0,0],radius:0,stiffness:this.rails.stiffness,time:e})}step(e){let t=this.pads.read();return t?(t.pressed&&this.grabMiddle(),t.released&&this.release(),this.holds&&Math.abs(t.x)>.15&&this.shift(t.x*this.rails.span()*.5*e),this.pads.rumble(this.holds?this.rails.force():0),this.holds):!1}at(e){let t=this.rails.canvas.getBoundingClientRect();return{x:e.clientX-t.left,y:e.clientY-t.top}}down(e){let{x:t,y:n}=this.at(e),s=this.rails.mayAct()&&e.button===0&&this.finger<0?this.rails.reach(t,n,e.pointerType==="touch"):null;s&&(this.rails.canvas.setPointerCapture(e.pointerId),this.finger=e.pointerId,this.holds=!0,this.point=s.point,this.offset=s.near?s.place-this.rails.metres(t):0,this.follow(t,e.timeStamp))}move(e){let{x:t,y:n}=this.at(e);this.holds&&e.pointerId===this.finger?this.follow(t,e.timeStamp):this.holds||(this.rails.canvas.dataset.over=this.rails.mayAct()&&this.rails.reach(t,n,!1)?"grab":"rails")}up(e){e.pointerId===this.finger&&this.release(e.timeStamp)}follow(e,t){this.target=this.rails.metres(e)+this.offset,this.send(t),this.rails.draw()}shift(e){let t=this.rails.span();this.target=Math.min(Math.max(this.target+e,this.rails.metres(0)-t),this.rails.metres(0)+2*t),this.send(),this.rails.draw()}grabMiddle(){let e=this.rails.mayAct()&&!this.holds?this.rails.reach(NaN,NaN,!0):null;e&&(this.holds=!0,this.point=e.point,this.target=e.place,this.send(),this.rails.draw())}key(e){if(!Tp(e)){if(e.key==="Escape"&&this.holds)this.release();else{if(document.activeElement!==this.rails.canvas&&document.activeElement!==document.body)return;if(e.key==="g"||e.key==="G")this.holds?this.release():this.grabMiddle();else if(this.holds&&(e.key==="ArrowLeft"||e.key==="ArrowRight"))this.shift((e.key==="ArrowLeft"?-.02:.02)*this.rails.span());else return}e.preventDefault()}}};var rx={light:{text:"#1b2330",soft:"#55606f",rail:"#d3dae4",line:"rgb(27 35 48 / 0.09)",paper:"#ffffff",dark:!1},dark:{text:"#eef1f5",soft:"#a7b0bd",rail:"#3a424f",line:"rgb(255 255 255 / 0.08)",paper:"#171b22",dark:!0}};function ra(i,e,t,n,s){i.font=`${s.weight??400} ${s.size}px system-ui, sans-serif`,i.fillStyle=s.colour,i.textAlign=s.align??"left",i.textBaseline="middle",i.fillText(e,t,n)}function Ap(i,e,t,n,s,r){i.lineCap="round",i.lineWidth=s,i.strokeStyle=r,i.beginPath(),i.moveTo(e,n),i.lineTo(t,n),i.stroke()}function ox(i,e,t,n,s,r,o){i.save(),i.shadowColor=r.dark?"rgb(0 0 0 / 0.55)":"rgb(20 30 50 / 0.28)",i.shadowBlur=o?14:8,i.shadowOffsetY=o?4:2,i.fillStyle=r.dark?"#f3f5f8":"#ffffff",sa(i,e,t,n),i.restore();let[a,l,c]=es(s),h=i.createLinearGradient(e,t-n,e,t+n);h.addColorStop(0,`rgb(${[a,l,c].map(u=>Math.round(u+(255-u)*.22)).join(" ")})`),h.addColorStop(1,s),i.fillStyle=h,sa(i,e,t,n-2.5),i.strokeStyle="rgb(255 255 255 / 0.75)",i.lineWidth=1.5,i.lineCap="round",i.beginPath();for(let u of[-.22,0,.22])i.moveTo(e+u*n,t-.3*n),i.lineTo(e+u*n,t+.3*n);i.stroke()}function sa(i,e,t,n){i.beginPath(),i.arc(e,t,Math.max(n,0),0,2*Math.PI),i.fill()}function ax(i,e,t,n,s,r=2){i.strokeStyle=s,i.lineWidth=r,i.beginPath(),i.arc(e,t,n,0,2*Math.PI),i.stroke()}function Cp(i,e,t,n,s,r){i.beginPath(),i.moveTo(e,t-n),i.lineTo(e+n,t),i.lineTo(e,t+n),i.lineTo(e-n,t),i.closePath(),i.fillStyle=r.paper,i.fill(),i.fillStyle=Zs(s,.35),i.fill(),i.strokeStyle=s,i.lineWidth=1.75,i.lineJoin="round",i.stroke()}function lx(i,e,t,n,s){if(Math.abs(n)<5)return;let r=Math.sign(n);i.strokeStyle=i.fillStyle=s,i.lineWidth=3,i.lineCap="butt",i.beginPath(),i.moveTo(e,t),i.lineTo(e+n-7*r,t),i.stroke(),i.beginPath(),i.moveTo(e+n,t),i.lineTo(e+n-9*r,t-5),i.lineTo(e+n-9*r,t+5),i.fill()}function cx(i,e,t,n,s,r){Ap(i,e,t,n,s,r)}function hx(i,e,t,n,s,r,o,a,l,c){let h=(e+n)/2+2*r,u=(t+s)/2,d=Math.hypot(n-e,s-t)+Math.abs(r);i.strokeStyle=a,i.lineJoin="round",i.lineCap="round",i.lineWidth=1.8+1.6*o,i.setLineDash(l?[2,7]:[]),i.beginPath();let f=Math.max(4,Math.round(d/15)),m=l?24:f*10,y=l||c?0:6.5*(1-.45*o);for(let p=0;p<=m;p++){let g=p/m,v=1-g,M=v*v*e+2*v*g*h+g*g*n,_=v*v*t+2*v*g*u+g*g*s,E=2*v*(h-e)+2*g*(n-h),T=2*v*(u-t)+2*g*(s-u),x=Math.hypot(E,T)||1,S=Math.min(1,Math.max(0,(Math.min(g,v)*d-16)/14)),O=y*S*Math.sin(g*f*2*Math.PI);M+=-T/x*O,_+=E/x*O,p?i.lineTo(M,_):i.moveTo(M,_)}i.stroke(),i.setLineDash([])}var ux=900,Rp=matchMedia("(prefers-reduced-motion: reduce)");function dx(i,e,t,n,s){return new Pp(i,e,t,n,s)}var Pp=class{constructor(e,t,n,s,r){this.scene=t;this.store=n;this.connection=s;this.stats=r;this.stiffness=t.stiffness,this.canvas.className="ct-canvas",this.canvas.dataset.over="rails",this.canvas.tabIndex=0,this.canvas.setAttribute("role","application"),this.canvas.setAttribute("aria-label","One slider for every user. Drag yours; G grabs, arrows move, Escape lets go."),e.append(this.canvas),this.furniture=new yo(e,n,{act:"Drag your slider to feel the others.",look:""}),this.furniture.legend("plain",""),this.drag=new xu(this,s);let o=new ResizeObserver(()=>this.resize());o.observe(e);let a=()=>this.draw();this.ends.push(()=>o.disconnect(),eo(a),n.on("settings",a),n.on("frame",a),n.on("state",a),n.on("slot",()=>{this.drag.release(),this.draw()}),n.on("connection",()=>{n.connection==="open"&&this.drag.holds&&this.drag.send()})),this.resize()}scene;store;connection;stats;canvas=document.createElement("canvas");stiffness;pen=this.canvas.getContext("2d");drag;furniture;ends=[];width=0;height=0;shown=null;handle=0;last=0;half=.1;wanted=.1;proxy=0;pulsed={slot:-1,since:-1/0};reset(){this.wanted=.1,this.draw()}pulse(e){this.pulsed={slot:e,since:performance.now()},this.draw()}spot(e=0){let t=this.copy(this.store.slot);return t?{x:this.x(this.place(t,e)),y:this.y(this.store.slot),point:e}:null}aim(e){let t=e-this.canvas.getBoundingClientRect().left,n=this.reach(t,this.y(this.store.slot),!0);return n&&{point:n.point,to:[this.metres(t),0,0]}}dispose(){cancelAnimationFrame(this.handle),this.handle=-1,this.drag.dispose(),this.furniture.dispose();for(let e of this.ends)e();this.canvas.remove()}reach(e,t,n){let s=this.copy(this.store.slot);if(!s)return null;let r=Number.isNaN(e);if(!r&&Math.abs(t-this.y(this.store.slot))>Math.max(this.gap*.45,n?34:24))return null;let o=0,a=1/0;for(let l=0;l<this.shown.points;l++){let c=Math.abs(this.x(this.place(s,l))-(r?this.x(this.scene.centre[0]):e));c<a&&([a,o]=[c,l])}return{point:o,place:this.place(s,o),near:a<44}}metres(e){return this.scene.centre[0]+(e-this.middle)/(this.right-this.left)*2*this.half}span(){return 2*this.half}force(){return Math.min(this.pull()/this.most,1)}mayAct(){return this.connection.mayAct}whose(e){return this.scene.users.find(({slot:t})=>Math.abs(this.y(t)-e)<this.gap/2)?.slot??null}take(e){this.scene.own.includes(e)&&this.store.take(e)}draw(){this.handle||(this.handle=requestAnimationFrame(e=>this.tick(e)))}get narrow(){return this.width<620}get left(){return this.narrow?30:168}get right(){return this.width-(this.narrow?30:104)}get middle(){return(this.left+this.right)/2}get gap(){return(this.height-this.foot-30)/this.scene.users.length}get foot(){return 108}get most(){return this.scene.stiffness*this.half}y(e){return 26+this.gap*(this.scene.users.findIndex(t=>t.slot===e)+.5)+(this.narrow?8:0)}x(e){return this.middle+(e-this.scene.centre[0])/(2*this.half)*(this.right-this.left)}copy(e){return this.shown?.copies.find(t=>t.slot===e)}place(e,t){return this.scene.points[3*t]+e.displacement[3*t]*this.shown.scale}mean(e){let t=0;for(let n=0;n<this.shown.points;n++)t+=this.place(e,n);return t/Math.max(this.shown.points,1)}pull(){let e=this.copy(this.store.slot);return this.drag.holds&&e?this.stiffness*Math.abs(this.drag.target-this.place(e,this.drag.point)):0}resize(){let e=this.canvas.parentElement?.getBoundingClientRect();if(!e||e.width<1||e.height<1)return;[this.width,this.height]=[Math.round(e.width),Math.round(e.height)];let t=devicePixelRatio||1;this.canvas.width=Math.round(this.width*t),this.canvas.height=Math.round(this.height*t),this.pen.setTransform(t,0,0,t,0,0),this.draw()}tick(e){this.handle=0;let t=Math.min((e-this.last)/1e3,.1);this.last=e;let n=this.store.frame!==null&&this.store.frame!==this.shown;this.shown=this.store.frame;let s=this.drag.step(t);s=this.range(t)||s,s=this.lag(t)||s,s=e-this.pulsed.since<ux||s,this.paint(e),n&&this.stats.drew(this.shown.echo,this.shown.received,performance.now()),s&&this.draw()}range(e){if(!this.shown||this.drag.holds)return!1;let t=0;for(let n of this.shown.copies){for(let s=0;s<this.shown.points;s++)t=Math.max(t,Math.abs(this.place(n,s)-this.scene.centre[0]));n.hasHand&&n.mode!=="free"&&(t=Math.max(t,Math.abs(n.target[0]-this.scene.centre[0])))}return(t>.92*this.wanted||t<.3*this.wanted)&&(this.wanted=Math.max(go(t*1.15),.1)),this.half+=(this.wanted-this.half)*(Rp.matches?1:1-Math.exp(-e*5)),Math.abs(this.half-this.wanted)>.001*this.wanted?!0:(this.half=this.wanted,!1)}lag(e){let t=this.copy(this.store.slot);if(!this.drag.holds||!t)return this.proxy=NaN,!1;Number.isNaN(this.proxy)&&(this.proxy=this.drag.target);let n=this.force(),s=this.place(t,this.drag.point),r=this.drag.target+(s-this.drag.target)*.6*n/(n+.45);return this.proxy+=(r-this.proxy)*(Rp.matches?1:1-Math.exp(-e*55)),Math.abs(r-this.proxy)>1e-4*this.half}paint(e){let{pen:t,store:n}=this,s=Ks(n.settings.theme),r=rx[s?"dark":"light"];t.clearRect(0,0,this.width,this.height),this.scale(r);let o=this.scene.users.map(a=>a.slot);for(let a of o)this.rail(a,r,e);this.springs(r);for(let a of o)this.beliefs(a,r);for(let a of o)this.slider(a,r);this.key(r)}scale(e){let{pen:t}=this,n=this.height-this.foot+4;for(let s=-4;s<=4;s++){let r=Math.round(this.middle+s/8*(this.right-this.left))+.5;if(t.strokeStyle=s===0?Zs(e.dark?"#ffffff":"#1b2330",.22):e.line,t.lineWidth=1,t.beginPath(),t.moveTo(r,22),t.lineTo(r,n),t.stroke(),s%2===0&&!(this.narrow&&Math.abs(s)>2)){let o=s===0?"rest":`${s>0?"+":""}${oc(s/4*this.half,this.half/2)}`;ra(t,o,r,n+13,{size:11.5,colour:e.soft,align:"center"})}}}key(e){let t=this.height-25,n=this.narrow?22:32;Cp(this.pen,n,t,5.5,e.soft,e),ra(this.pen,"where a user sees a neighbour",n+13,t,{size:12,colour:e.soft})}rail(e,t,n){let{pen:s,store:r}=this,o=wi(e,t.dark),a=this.y(e),l=e===r.slot,c=this.copy(e),h=!c||r.state?.members[e]?.here===!1;l&&(s.fillStyle=Zs(o,t.dark?.13:.07),s.beginPath(),s.roundRect(8,a-this.gap*.46,this.width-16,this.gap*.92,14),s.fill());let u=(n-this.pulsed.since)/ux;e===this.pulsed.slot&&u<1&&(s.strokeStyle=Zs(o,Rp.matches?.8:Math.sin(u*Math.PI*3)**2),s.lineWidth=3,s.beginPath(),s.roundRect(8,a-this.gap*.46,this.width-16,this.gap*.92,14),s.stroke()),Ap(s,this.left,this.right,a,l?7:5,t.rail);let d=this.scene.users.find(_=>_.slot===e).name,f=r.state?rc(r.state,r.slot).get(e):void 0,m=c&&!c.direct?`, ${cs(c.age)} old`:"",y=h?"not here":e===r.me?"you":l?"":r.state?f===void 0?"out of reach":this.narrow?`+${cs(f)}`:r.me===null?`${cs(f)} after ${this.scene.users.find(_=>_.slot===r.slot)?.name}${m}`:`feels you ${cs(f)} later${m}`:"",[p,g]=this.narrow?[this.left-8,a-this.gap*.33]:[26,a-9];ra(s,d,p,g,{size:15,weight:650,colour:h?t.soft:o});let v=this.narrow?[p+s.measureText(d).width+8,g]:[p,a+10];if(ra(s,y,v[0],v[1],{size:12,colour:t.soft}),h)return;let M=l&&this.drag.holds?this.pull():Math.abs(c.force[0]);if(M>.005){let[_,E]=this.narrow?[this.right+8,g]:[this.width-26,a];ra(s,ac(M),_,E,{size:13,weight:600,colour:t.text,align:"right"})}}springs(e){let{state:t}=this.store;if(!t||!this.shown)return;let n=s=>this.scene.users.findIndex(r=>r.slot===s);for(let[s,r]of t.links){let[o,a]=[this.copy(s),this.copy(r)];if(!o||!a)continue;let[l,c]=[this.mean(o),this.mean(a)],h=!!t.emulated[`${s}-${r}`]?.cut||!!t.emulated[`${r}-${s}`]?.cut,u=t.ends[`${s}-${r}`],d=h||u&&u.state!=="coupled"&&u.state!=="ready"&&u.state!=="guarded",f=Math.min(Math.abs(l-c)/(.6*this.half),1),m=Math.abs(n(s)-n(r)),y=m<2?0:(m-1)*Math.min(this.gap*.42,38)*((n(s)+n(r))%2?1:-1),p=d?Zs(e.dark?"#a7b0bd":"#55606f",.55):Ca(f,e.dark);hx(this.pen,this.x(l),this.y(s),this.x(c),this.y(r),y,f,p,!!d,!1)}}beliefs(e,t){let{state:n,history:s}=this.store;if(!(!n||!this.copy(e)))for(let[r,o]of n.links){if(r!==e&&o!==e)continue;let a=r===e?o:r,l=Kd(n,e,a);if(l===null||!this.copy(a))continue;let c=s.before(a,l);if(Number.isNaN(c))continue;let h=0;for(let u=0;u<this.shown.points;u++)h+=this.scene.points[3*u]/this.shown.points;Cp(this.pen,this.x(h+c),this.y(e),6,wi(a,t.dark),t)}}slider(e,t){let n=this.copy(e);if(!n)return;let{pen:s}=this,r=wi(e,t.dark),o=this.y(e),a=e===this.store.slot,l=a&&this.drag.holds,c=Math.min(a?19:15,this.gap*.3),h=l?this.drag.point:Math.max(n.node,0),u=l||n.hasHand&&n.mode!=="free"&&n.node>=0,d=this.x(this.place(n,Math.min(h,this.shown.points-1))),f=l?Math.sign(this.drag.target-this.place(n,h))*this.pull():n.force[0];if(u){let y=Math.min(Math.abs(f)/this.most,1),p=this.x(l?this.drag.target:n.target[0]);cx(s,d,p,o,3+4*y,Ca(y,t.dark)),l?(s.fillStyle=r,sa(s,this.x(this.proxy),o,7),ax(s,p,o,12,r,2.5)):(s.fillStyle=r,sa(s,p,o,5))}if(this.shown.points>1)for(let y=0;y<this.shown.points;y++)s.fillStyle=Zs(r,.85),sa(s,this.x(this.place(n,y)),o,Math.min(c*.5,8));let m=this.shown.points>1&&u?d:this.x(this.mean(n));ox(s,m,o,c,r,t,a),u&&lx(s,m,o-c-8,f/this.most*(this.right-this.left)*.3,r)}};function fx({heights:i,rows:e,columns:t,size:n,top:s,angle:r,projection:o}){let a=new Float32Array(2*e*t),l=(m,y)=>i[(m+e)%e*t+(y+t)%t]/65535*s,c=0;for(let m=0;m<e;m++)for(let y=0;y<t;y++){let p=2*(m*t+y);a[p]=(l(m,y+1)-l(m,y-1))*t/(2*n[0]),a[p+1]=(l(m+1,y)-l(m-1,y))*e/(2*n[1]),c=Math.max(c,Math.abs(a[p]),Math.abs(a[p+1]))}c=c||1;let h=new Uint8Array(4*e*t);for(let m=0;m<e*t;m++)h[4*m]=128+Math.round(127*a[2*m]/c),h[4*m+1]=128+Math.round(127*a[2*m+1]/c),h[4*m+2]=i[m]>>8,h[4*m+3]=255;let u=new Bo(h,t,e,bi,ii);u.wrapS=u.wrapT=Fo,u.magFilter=An,u.minFilter=_i,u.generateMipmaps=!0,u.needsUpdate=!0;let d=["x","y","z"].indexOf(o),f=new F;return d>=0&&f.setComponent(d,1),{tile:{value:u},tiles:{value:new Fe(1/n[0],1/n[1])},turn:{value:new Fe(Math.cos(r),Math.sin(r))},steep:{value:c},along:{value:f}}}function px(i,e){let{points:t}=i,n=i.skin.triangles,s=new Float32Array(t.length);for(let a=0;a<n.length;a+=3){let[l,c,h]=[3*n[a],3*n[a+1],3*n[a+2]],u=t[c]-t[l],d=t[c+1]-t[l+1],f=t[c+2]-t[l+2],m=t[h]-t[l],y=t[h+1]-t[l+1],p=t[h+2]-t[l+2],g=[d*p-f*y,f*m-u*p,u*y-d*m];for(let v of[l,c,h])for(let M=0;M<3;M++)s[v+M]+=g[M]}let r=0;for(let{vertices:a,bare:l}of i.parts)l&&s.fill(0,3*r,3*(r+a)),r+=a;let o=new Float32Array(3*e.length);return e.forEach((a,l)=>{let[c,h,u]=[s[3*a],s[3*a+1],s[3*a+2]],d=Math.hypot(c,h,u)||1;o.set([c/d,h/d,u/d],3*l)}),o}var mx=[2,1,.75,.55,.4],_u=class{constructor(e){this.finest=e;this.level=e()>1?0:1}finest;level;drawn=0;missed=0;kept=0;wait=240;get ratio(){return Math.min(this.finest(),mx[this.level])}get shadows(){return this.level>2?3:1}took(e,t){let n=this.ratio;this.drawn++;let s=t>.021?Math.min(e,6):0;return this.missed+=s,this.kept=s?0:this.kept+1,this.drawn>=24&&(this.missed>.06*(this.drawn+this.missed)&&this.level<mx.length-1&&(this.level++,this.kept=0,this.wait=Math.min(2*this.wait,15360)),this.drawn=this.missed=0),this.kept>this.wait&&this.level>0&&this.ratio<this.finest()&&(this.level--,this.kept=this.drawn=this.missed=0),this.ratio!==n}},mC=null;function Ii(){return mC??=gC()}function gC(){let i=document.createElement("canvas").getContext("webgl2"),e=i?.getExtension("WEBGL_debug_renderer_info"),t=i&&e?String(i.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";return i?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software/i.test(t)}function oa(){return Ii()?{LEAN:""}:{}}var _l=`
#ifdef LEAN
vec3 toLinear(vec3 c) { return c * c; }
vec3 toScreen(vec3 c) { return sqrt(c); }
float gleam(float x) { x *= x; x *= x; x *= x; x *= x; return x * x; }
float edge(float x) { return x * x * x; }
#else
vec3 toLinear(vec3 c) { return pow(c, vec3(2.2)); }
vec3 toScreen(vec3 c) { return pow(c, vec3(1.0 / 2.2)); }
float gleam(float x) { return pow(x, 42.0); }
float edge(float x) { return pow(x, 3.5); }
#endif
vec3 lit(vec3 colour, vec3 n, vec3 eye, float gloss) {
  vec3 key = normalize(vec3(-0.45, 0.8, 0.55)), fill = normalize(vec3(0.9, 0.05, 0.35));
  float up = 0.5 + 0.5 * n.y;
  float wrap = max(dot(n, key) * 0.85 + 0.15, 0.0);
  vec3 light = mix(vec3(0.30, 0.29, 0.33), vec3(0.60, 0.62, 0.66), up) + 0.78 * wrap * vec3(1.0, 0.98, 0.94)
    + 0.16 * max(dot(n, fill), 0.0) * vec3(0.8, 0.9, 1.0);
  vec3 halfway = normalize(key + eye);
  float shine = gleam(max(dot(n, halfway), 0.0)) * gloss;
  float rim = edge(1.0 - max(dot(n, eye), 0.0));
  return toScreen(toLinear(colour) * light + shine + rim * 0.10 * vec3(0.8, 0.9, 1.0));
}
`,bu=`
uniform vec3 stops[9];
vec3 ramp(float value) {
  float at = clamp(value, 0.0, 1.0) * 8.0;
  int low = min(int(at), 7);
  return mix(stops[low], stops[low + 1], at - float(low));
}
`,yC=`
#ifdef RELIEF
uniform sampler2D tile;
uniform vec2 tiles, turn;
uniform float steep;
uniform vec3 along;
/** Slopes along two axes, and height, seen along the third. */
vec3 laid(vec2 at) {
  vec3 found = texture2D(tile, vec2(dot(at, turn), turn.x * at.y - turn.y * at.x) * tiles).rgb;
  vec2 slope = (found.rg * 255.0 - 128.0) / 127.0 * steep;
  return vec3(turn.x * slope.x - turn.y * slope.y, turn.y * slope.x + turn.x * slope.y, found.b);
}
/** The normal of the skin with its texture; colour gets what hollows lack of light. q: place, at: at rest, m: normal. */
vec3 rough(vec3 q, vec3 at, vec3 looks, vec3 m, inout vec3 colour) {
  vec3 share = looks * looks;
  share *= share;
  float all = share.x + share.y + share.z;
  share = all > 1e-6 ? (along == vec3(0.0) ? share / all : along) : vec3(0.0);
  vec3 x = vec3(0.0), y = vec3(0.0), z = vec3(0.0);
  if (along.y + along.z == 0.0) x = laid(at.yz);
  if (along.x + along.z == 0.0) y = laid(at.xz);
  if (along.x + along.y == 0.0) z = laid(at.xy);
  vec3 slope = share.x * vec3(0.0, x.xy) + share.y * vec3(y.x, 0.0, y.y) + share.z * vec3(z.xy, 0.0);
  slope *= min(1.0, 3.0 / max(length(slope), 1e-6));
  float height = dot(share, vec3(x.z, y.z, z.z));
  if (all > 1e-6) colour *= 0.86 + 0.14 * height;
  // What rises from pixel to pixel tilts the normal, however the skin is stretched [Mikkelsen 2010].
  vec3 right = dFdx(q), over = dFdy(q), first = cross(over, m), second = cross(m, right);
  float size = dot(right, first);
  vec3 rises = sign(size) * (dot(slope, dFdx(at)) * first + dot(slope, dFdy(at)) * second);
  vec3 tilted = abs(size) * m - rises;
  return dot(tilted, tilted) > 0.0 ? normalize(tilted) : m;
}
#endif
`,Ip={vertex:`
    ${_l}${bu}
    attribute vec3 shift, tint;
    attribute float value;
    uniform float scale, full, flash, tinted;
    uniform vec3 plain;
    uniform int by;
    #if defined(LEAN) && !defined(RELIEF)
    varying vec3 shown;
    #else
    varying vec3 n, p, own;
    varying float v;
    #endif
    #ifdef RELIEF
    attribute vec3 looks;
    varying vec3 stands, faces;
    #endif
    void main() {
      vec4 q = modelViewMatrix * vec4(position + shift * scale, 1.0);
      float far = (by == 0 ? length(shift) * scale : value) / full;
      gl_Position = projectionMatrix * q;
      #ifdef RELIEF
      stands = position;
      faces = looks;
      #endif
      #if defined(LEAN) && !defined(RELIEF)
      vec3 eye = normalize(-q.xyz), m = normalize(mat3(modelViewMatrix) * normal + 1e-20);
      if (dot(m, eye) < -0.2) m = -m;
      shown = mix(lit(by == 2 ? (tinted > 0.0 ? tinted * tint : plain) : ramp(far), m, eye, 0.20), vec3(1.0), flash * 0.5);
      #else
      n = mat3(modelViewMatrix) * normal;
      p = q.xyz;
      own = tinted > 0.0 ? tinted * tint : plain;
      v = far;
      #endif
    }`,fragment:`
    #if defined(LEAN) && !defined(RELIEF)
    varying vec3 shown;
    void main() { gl_FragColor = vec4(shown, 1.0); }
    #else
    ${_l}${bu}${yC}
    uniform int by;
    uniform float flash;
    varying vec3 n, p, own;
    varying float v;
    #ifdef RELIEF
    varying vec3 stands, faces;
    #endif
    void main() {
      vec3 eye = normalize(-p), m = normalize(n);
      if (!gl_FrontFacing) m = -m;
      vec3 colour = by == 2 ? own : ramp(v);
      #ifdef RELIEF
      m = rough(p, stands, faces, m, colour);
      #endif
      gl_FragColor = vec4(mix(lit(colour, m, eye, 0.20), vec3(1.0), flash * 0.5), 1.0);
    }
    #endif`},gx={vertex:`
    attribute vec3 shift, own;
    uniform float scale, apart, flash, strength;
    #ifndef LEAN
    varying vec3 n, p;
    #endif
    varying float v;
    void main() {
      vec4 q = modelViewMatrix * vec4(position + shift * scale, 1.0);
      // Where both surfaces cross they differ along neither's normal: no seam is seen.
      vec3 differs = (shift - own) * scale / apart;
      v = max(smoothstep(0.1, 1.0, dot(differs, normalize(normal + 1e-20))), 0.5 * smoothstep(3.0, 8.0, length(differs)));
      gl_Position = projectionMatrix * q;
      #ifdef LEAN
      float rim = 1.0 - abs(dot(normalize(mat3(modelViewMatrix) * normal + 1e-20), normalize(-q.xyz)));
      v = min(v * strength * (0.05 + 0.95 * rim * sqrt(rim)) + flash * 0.35, 1.0);
      #else
      n = mat3(modelViewMatrix) * normal;
      p = q.xyz;
      #endif
    }`,fragment:`
    uniform vec3 colour;
    uniform float flash, strength;
    varying float v;
    #ifdef LEAN
    void main() { gl_FragColor = vec4(mix(colour, vec3(1.0), flash * 0.3), v); }
    #else
    varying vec3 n, p;
    void main() {
      float rim = 1.0 - abs(dot(normalize(n), normalize(-p)));
      float cover = v * strength * (0.05 + 0.95 * pow(rim, 1.5)) + flash * 0.35;
      gl_FragColor = vec4(mix(colour, vec3(1.0), flash * 0.3), min(cover, 1.0));
    }
    #endif`},Mu={vertex:`
    attribute vec3 shift;
    attribute float value;
    uniform float scale, full, size, height;
    uniform int by;
    varying float v;
    void main() {
      vec4 q = modelViewMatrix * vec4(position + shift * scale, 1.0);
      v = (by == 0 ? length(shift) * scale : value) / full;
      gl_Position = projectionMatrix * q;
      gl_PointSize = max(size * projectionMatrix[1][1] * height / gl_Position.w, 3.0);
    }`,fragment:`
    ${_l}${bu}
    uniform vec3 plain;
    uniform int by;
    uniform float opacity, flash;
    varying float v;
    void main() {
      vec2 c = vec2(2.0, -2.0) * (gl_PointCoord - 0.5);
      float r = dot(c, c);
      if (r > 1.0) discard;
      vec3 colour = by == 2 ? plain : ramp(v);
      gl_FragColor = vec4(mix(lit(colour, vec3(c, sqrt(1.0 - r)), vec3(0, 0, 1), 0.25), vec3(1.0), flash * 0.5), opacity);
    }`},Lp={vertex:Mu.vertex.replace(/gl_PointSize.*\n/,`
`),fragment:`
    ${bu}
    uniform vec3 plain;
    uniform int by;
    uniform float opacity;
    varying float v;
    void main() { gl_FragColor = vec4((by == 2 ? plain : ramp(v)) * 0.85, opacity); }`},Np={vertex:`
    ${_l}
    uniform vec3 colour;
    #ifdef LEAN
    varying vec3 shown;
    #else
    varying vec3 n, p;
    #endif
    void main() {
      vec4 q = modelViewMatrix * vec4(position, 1.0);
      #ifdef LEAN
      shown = lit(colour, normalize(normalMatrix * normal), normalize(-q.xyz), 0.35);
      #else
      n = normalMatrix * normal;
      p = q.xyz;
      #endif
      gl_Position = projectionMatrix * q;
    }`,fragment:`
    uniform float opacity;
    #ifdef LEAN
    varying vec3 shown;
    void main() { gl_FragColor = vec4(shown, opacity); }
    #else
    ${_l}
    uniform vec3 colour;
    varying vec3 n, p;
    void main() { gl_FragColor = vec4(lit(colour, normalize(n), normalize(-p), 0.35), opacity); }
    #endif`},Dp={vertex:`
    attribute vec3 shift;
    uniform float scale, ground, reach;
    varying float height;
    void main() {
      vec4 q = modelMatrix * vec4(position + shift * scale, 1.0);
      height = (q.z - ground) / reach;
      gl_Position = projectionMatrix * viewMatrix * q;
    }`,fragment:`
    varying float height;
    void main() { gl_FragColor = vec4(1.0, clamp(height, 0.0, 1.0), 0.0, 1.0); }`},Fp={vertex:`
    varying vec2 at;
    void main() {
      vec4 q = modelMatrix * vec4(position, 1.0);
      at = q.xy;
      gl_Position = projectionMatrix * viewMatrix * q;
    }`,fragment:`
    uniform sampler2D shadow;
    uniform vec2 centre;
    uniform vec3 line, dark;
    uniform float reach, pitch, strength, opacity, plate;
    varying vec2 at;
    float lines(vec2 q) {
      vec2 width = max(fwidth(q), 1e-6);
      vec2 l = clamp(1.15 - abs(fract(q - 0.5) - 0.5) / width, 0.0, 1.0) * clamp(0.5 / width - 1.0, 0.0, 1.0);
      return max(l.x, l.y);
    }
    void main() {
      vec2 d = (at - centre) / reach;
      float away = length(d), cover = 0.0, fade = smoothstep(2.1, 0.3, away);
      vec2 q = (at - centre) / pitch;
      if (away > 2.1) discard;
      #ifdef LEAN
      if (away < 1.1) {
        vec4 seen = textureLod(shadow, vec2(0.5 + 0.5 * d.x, 0.5 - 0.5 * d.y), 2.5);
        if (seen.r > 0.003) cover = strength * seen.r * (1.0 - 0.75 * min(seen.g / seen.r, 1.0));
      }
      #else
      if (away < 1.3) {
        vec2 uv = vec2(0.5 + 0.5 * d.x, 0.5 - 0.5 * d.y);
        vec4 far = textureLod(shadow, uv, 4.6);
        if (far.r > 0.003) {
          float h = far.g / far.r;
          float soft = mix(mix(textureLod(shadow, uv, 2.5).r, textureLod(shadow, uv, 3.5).r, smoothstep(0.0, 0.2, h)), far.r, smoothstep(0.15, 0.6, h));
          cover = strength * soft * (1.0 - 0.75 * smoothstep(0.0, 1.0, h));
        }
      }
      #endif
      float grid = max(opacity * max(lines(q), 0.55 * lines(q * 5.0)), plate) * fade;
      float all = cover + grid * (1.0 - cover);
      gl_FragColor = vec4(mix(line, dark, cover / max(all, 1e-4)), all);
    }`};var[Ml,bl,Su]=[new F,new F,new F],Up=new F,vC=new Ht,xC=(i,e,t)=>i>=e&&i<t;function vx({parts:i,points:e},t,n,s){let r=l=>new F().fromArray(e,3*l),o=[],a=0;for(let{vertices:l,tool:c}of i){let h=a+l;if(c){let u=Array.from({length:l},(M,_)=>a+_),d=M=>u.reduce((_,E)=>M(r(E))>M(r(_))?E:_),f=a,m=d(M=>M.distanceToSquared(r(f))),y=r(m).sub(r(f)),p=d(M=>M.sub(r(f)).cross(y).lengthSq()),[g,v]=[a,h];o.push({slot:c.slot,first:a,last:h,handle:new F(...c.handle),corners:[t[f],t[m],t[p]],triangles:(s??new Uint32Array).filter((M,_,E)=>xC(n[E[_-_%3]],g,v))})}a=h}return o}function Op(i,e,t){let n=yx(i,t).multiply(yx(i,e).invert()),s=new F().fromArray(e,3*i.corners[0]);return{handle:i.handle.clone().sub(s).applyQuaternion(n).add(Ml.fromArray(t,3*i.corners[0])),turned:n}}function xx(i,e,t,n){let s=0;for(let r=0;r<i.triangles.length;r+=3){let[o,a,l]=[i.triangles[r],i.triangles[r+1],i.triangles[r+2]];if(!e.intersectTriangle(Ml.fromArray(t,3*o),bl.fromArray(t,3*a),Su.fromArray(t,3*l),!1,Up))continue;let c=Up.distanceToSquared(e.origin);c<=s||(s=c,n.copy(Up))}return s>0}function yx({corners:[i,e,t]},n){Ml.fromArray(n,3*i),bl.fromArray(n,3*e).sub(Ml).normalize(),Su.fromArray(n,3*t).sub(Ml);let s=new F().crossVectors(bl,Su).normalize();return new fn().setFromRotationMatrix(vC.makeBasis(bl,Su.crossVectors(s,bl),s))}var _C=Math.cos(50*Math.PI/180),wu=class{constructor(e){this.scene=e;this.loose=e.cutting!=null;let t=e.points.length/3;if(e.skin){let s=SC(e.points,e.skin.triangles);this.point=s.point,this.triangles=s.triangles}else this.point=Uint32Array.from({length:t},(s,r)=>r),this.triangles=null;this.corners=this.point.length,this.rest=new Float32Array(this.corners*3),this.corner=new Uint32Array(t),this.point.forEach((s,r)=>{this.corner[s]=r;for(let o=0;o<3;o++)this.rest[3*r+o]=e.points[3*s+o]}),this.tools=vx(e,this.corner,this.point,this.triangles),this.looks=e.skin&&e.texture?px(e,this.point):null,this.tint=e.parts.length?bC(e.parts,this.point):null,this.sides=e.skin?MC(e.skin.triangles,this.corner,t):e.edges??new Uint32Array;let n=this.sides.length/2;this.restLengths=new Float32Array(n),this.degree=new Float32Array(this.corners);for(let s=0;s<n;s++){let r=this.sides[2*s],o=this.sides[2*s+1];this.restLengths[s]=_x(this.rest,r,o),this.degree[r]++,this.degree[o]++}for(let s=0;s<this.corners;s++)this.degree[s]=Math.max(this.degree[s],1)}scene;point;rest;triangles;sides;corner;restLengths;degree;corners;tint;looks;tools;loose};function bC(i,e){let t=i.flatMap(({vertices:n,colour:s},r)=>{let o=es(um(r,s)).map(a=>a/255);return Array.from({length:n},()=>o)});return Float32Array.from(Array.from(e).flatMap(n=>t[n]??[1,1,1]))}var Eu=class{constructor(e){this.shape=e;this.triangles=e.triangles;let t=e.corners,n=(r,o)=>new Mn(r,o).setUsage(ml);this.places=e.rest.slice(),this.seen=new Uint8Array(t),this.shift=n(new Int16Array(3*t),3),this.normal=n(new Float32Array(3*t),3),this.value=n(new Float32Array(t),1);let s=new Mn(e.rest,3);for(let r of[this.geometry,...e.triangles?[]:[this.lines=new pn]])r.setAttribute("position",s),r.setAttribute("shift",this.shift),r.setAttribute("value",this.value);if(e.triangles){this.geometry.setAttribute("normal",this.normal),e.looks&&this.geometry.setAttribute("looks",new Mn(e.looks,3)),e.tint&&this.geometry.setAttribute("tint",new Mn(e.tint,3));let r=e.loose?e.triangles.slice():e.triangles;this.geometry.setIndex(new Mn(r,1).setUsage(e.loose?ml:cu)),this.film=new pn;for(let o of["position","shift","normal"])this.film.setAttribute(o,this.geometry.getAttribute(o));this.film.setIndex(this.faces=new Mn(new Uint32Array(e.triangles.length),1).setUsage(ml))}this.lines?.setIndex(new Mn(e.sides,1)),e.scene.cutting&&this.cut(btoa("\0".repeat(Math.ceil(e.scene.cutting.elements/8)))),this.update(new Int16Array(e.scene.points.length),0,!1)}shape;geometry=new pn;lines=null;film=null;shift;places;mean=[0,0,0];peak=0;normal;value;faces=null;seen;triangles;gone=null;told=null;cut(e){let{cutting:t}=this.shape.scene;if(!t||e===null||e===this.told)return;this.told=e;let n=mm(e,t.elements),{pointer:s,element:r,beyond:o}=t;this.keep(a=>{let l=o[a]<0||n[o[a]]===1;for(let c=s[a];l&&c<s[a+1];c++)l=n[r[c]]===0;return l})}keep(e){let t=this.shape.triangles;if(!t)return;let n=this.geometry.index.array;this.gone=new Uint8Array(this.shape.corners).fill(1);let s=0;for(let r=0;3*r<t.length;r++)if(e(r))for(let o=0;o<3;o++)n[s++]=t[3*r+o],this.gone[t[3*r+o]]=0;this.triangles=n.subarray(0,s),this.geometry.setDrawRange(0,s),this.geometry.index.needsUpdate=!0}update(e,t,n){let{point:s,rest:r,corners:o}=this.shape,a=this.shift.array,{places:l,gone:c}=this,h=0,u=0,d=0,f=0;for(let m=0;m<o;m++){let y=3*m,p=3*s[m],g=e[p],v=e[p+1],M=e[p+2];a[y]=g,a[y+1]=v,a[y+2]=M,l[y]=r[y]+g*t,l[y+1]=r[y+1]+v*t,l[y+2]=r[y+2]+M*t,u+=g,d+=v,f+=M,!c?.[m]&&(h=Math.max(h,g*g+v*v+M*M))}this.mean[0]=u*t/o,this.mean[1]=d*t/o,this.mean[2]=f*t/o,this.shift.needsUpdate=!0,this.peak=n?this.stretch():Math.sqrt(h)*t,this.triangles&&this.normals(this.triangles)}colour(e){let t=this.value.array;this.shape.point.forEach((n,s)=>t[s]=e[n]),this.value.needsUpdate=!0}differs(e,t,n,s){let{corners:r}=this.shape,{triangles:o}=this;if(!o||!this.film||!this.faces)return!0;let{places:a,seen:l}=this,c=e.places,h=this.normal.array,[u,d]=[(.1*n)**2,(3*n)**2];for(let y=0;y<r;y++){let p=3*y,g=h[p],v=h[p+1],M=h[p+2],_=s;if(!_){let T=a[p]-c[p],x=a[p+1]-c[p+1],S=a[p+2]-c[p+2],O=T*g+x*v+S*M;_=O>0&&O*O>u*(g*g+v*v+M*M)||T*T+x*x+S*S>d}let E=g*(a[p]-t.x)+v*(a[p+1]-t.y)+M*(a[p+2]-t.z)<0;l[y]=(_?1:0)|(E?2:0)}let f=this.faces.array,m=0;for(let y=0;y<o.length;y+=3){let p=o[y],g=o[y+1],v=o[y+2];(l[p]|l[g]|l[v])===3&&(f[m++]=p,f[m++]=g,f[m++]=v)}return this.film.setDrawRange(0,m),this.faces.clearUpdateRanges(),this.faces.addUpdateRange(0,m),m&&(this.faces.needsUpdate=!0),m>0}dispose(){this.film?.dispose(),this.geometry.dispose(),this.lines?.dispose()}normals(e){let t=this.places,n=this.normal.array;n.fill(0);for(let s=0;s<e.length;s+=3){let r=3*e[s],o=3*e[s+1],a=3*e[s+2],l=t[o]-t[r],c=t[o+1]-t[r+1],h=t[o+2]-t[r+2],u=t[a]-t[r],d=t[a+1]-t[r+1],f=t[a+2]-t[r+2],m=c*f-h*d,y=h*u-l*f,p=l*d-c*u;n[r]+=m,n[r+1]+=y,n[r+2]+=p,n[o]+=m,n[o+1]+=y,n[o+2]+=p,n[a]+=m,n[a+1]+=y,n[a+2]+=p}this.normal.needsUpdate=!0}stretch(){let{sides:e,restLengths:t,degree:n,corner:s,point:r,corners:o}=this.shape,a=this.value.array;a.fill(0);for(let c=0;c<t.length;c++){let h=e[2*c],u=e[2*c+1];if(this.gone&&(this.gone[h]||this.gone[u]))continue;let d=Math.abs(_x(this.places,h,u)/Math.max(t[c],1e-12)-1);a[h]+=d/n[h],a[u]+=d/n[u]}let l=0;for(let c=0;c<o;c++)a[c]=a[s[r[c]]],l=Math.max(l,a[c]);return this.value.needsUpdate=!0,l}};function _x(i,e,t){let n=i[3*e]-i[3*t],s=i[3*e+1]-i[3*t+1],r=i[3*e+2]-i[3*t+2];return Math.sqrt(n*n+s*s+r*r)}function MC(i,e,t){let n=new Set,s=[];for(let r=0;r<i.length;r++){let o=i[r],a=i[r%3===2?r-2:r+1],l=Math.min(o,a)*t+Math.max(o,a);n.has(l)||(n.add(l),s.push(e[o],e[a]))}return Uint32Array.from(s)}function SC(i,e){let t=e.length/3,n=new Float32Array(3*t),s=Array.from({length:i.length/3},()=>[]);for(let c=0;c<t;c++){let[h,u,d]=[0,1,2].map(g=>3*e[3*c+g]),f=[0,1,2].map(g=>i[u+g]-i[h+g]),m=[0,1,2].map(g=>i[d+g]-i[h+g]),y=[f[1]*m[2]-f[2]*m[1],f[2]*m[0]-f[0]*m[2],f[0]*m[1]-f[1]*m[0]],p=Math.hypot(...y)||1;for(let g=0;g<3;g++)n[3*c+g]=y[g]/p,s[e[3*c+g]].push(c)}let r=(c,h)=>n[3*c]*n[3*h]+n[3*c+1]*n[3*h+1]+n[3*c+2]*n[3*h+2]>_C,o=(c,h,u)=>{for(let d=0;d<3;d++)for(let f=0;f<3;f++)if(e[3*c+d]===e[3*h+f]&&e[3*c+d]!==u)return!0;return!1},a=[],l=new Uint32Array(e.length);return s.forEach((c,h)=>{let u=new Set(c);for(let d of c){if(!u.delete(d))continue;let f=[d];for(let m=0;m<f.length;m++)for(let y of u)r(f[m],y)&&o(f[m],y,h)&&(u.delete(y),f.push(y));for(let m of f)for(let y=0;y<3;y++)e[3*m+y]===h&&(l[3*m+y]=a.length);a.push(h)}c.length||a.push(h)}),{point:Uint32Array.from(a),triangles:l}}var wC=Rl.map(i=>new F(...es(i)).divideScalar(255)),Tu=class{scale={value:0};full={value:1};by={value:0};stops={value:wC};apart;size;height={value:1};relief;constructor(e,t){this.apart={value:.05*e},this.relief=t.looks?fx(t.scene.texture):null;let n=t.restLengths,s=n.length?n.reduce((r,o)=>r+o,0)/n.length:e;this.size={value:Math.min(.17*s,.08*e)}}},Au=class{constructor(e,t,n){this.slot=e;this.moving=new Eu(t);let{geometry:s,lines:r,film:o}=this.moving,{relief:a,...l}=n,c={...l,plain:this.plain,flash:this.flash},h=(u,d,f)=>{let m=new Bn({defines:{...oa(),...u===Ip&&a?{RELIEF:""}:{}},vertexShader:u.vertex,fragmentShader:u.fragment,uniforms:{...c,...d},transparent:f,depthWrite:!f,side:f?0:2});return this.made.push(m),m};if(t.triangles)this.body.add(new en(s,h(Ip,{tinted:this.tinted,...a},!1))),this.shell.add(new en(o,h(gx,{colour:this.colour,strength:this.strength},!0)));else{let u={plain:this.colour,by:{value:2}};this.body.add(new Vo(s,h(Mu,{opacity:{value:1}},!1))),this.body.add(new Us(r,h(Lp,{opacity:{value:1}},!1))),this.shell.add(new Vo(s,h(Mu,{opacity:{value:.35},...u},!0))),this.shell.add(new Us(r,h(Lp,{opacity:{value:.35},...u},!0)))}for(let u of[...this.body.children,...this.shell.children])u.frustumCulled=!1;this.group.add(this.body,this.shell)}slot;moving;group=new ei;body=new ei;shell=new ei;made=[];plain={value:new F};colour={value:new F};tinted={value:0};flash={value:0};strength={value:1};against(e){this.moving.film?.setAttribute("own",e.shift)}paint(e,t){let[n,s,r]=es(e).map(o=>o/255);this.colour.value.set(n,s,r),this.plain.value.set(.9,.895,.875).lerp(this.colour.value,.22).multiplyScalar(t?.9:1),this.tinted.value=this.moving.shape.tint?t?.9:1:0,this.strength.value=t?1:.95}show(e,t){this.body.visible=e==="solid",this.shell.visible=e==="ghost",this.flash.value=t}thin(e,t,n){this.shell.visible&&(this.shell.visible=this.moving.differs(e,t,n,this.flash.value>0))}order(e){let[t,n,s]=this.moving.mean,r=e.x*t+e.y*n+e.z*s;for(let o of this.shell.children)o.renderOrder=10-r/(Math.abs(r)+1)}dispose(){this.moving.dispose();for(let e of this.made)e.dispose()}};var bx=Ii()?128:256,Cu=class{mesh;target=new ti(bx,bx,{minFilter:_i,magFilter:An,generateMipmaps:!0,depthBuffer:!0});scene=new Lr;camera;cast=null;shade;constructor(e,t,n,s,r){let o=r??t-.1*n,a=2*n;this.mesh=new en(new ks(9*n,9*n),new Bn({defines:oa(),vertexShader:Fp.vertex,fragmentShader:Fp.fragment,transparent:!0,depthWrite:!1,uniforms:{shadow:{value:this.target.texture},centre:{value:new Fe(e.x,e.y)},line:{value:new F},dark:{value:new F},reach:{value:a},pitch:{value:go(n*.9)},strength:{value:.3},opacity:{value:.5},plate:{value:r===null?0:.16}}})),this.mesh.position.set(e.x,e.y,o),this.mesh.renderOrder=-1,this.camera=new $o(-a,a,a,-a,0,12*n),this.camera.up.set(0,-1,0),this.camera.position.set(e.x,e.y,o-n),this.camera.lookAt(e.x,e.y,o),this.shade=new Bn({vertexShader:Dp.vertex,fragmentShader:Dp.fragment,side:2,uniforms:{scale:{value:0},ground:{value:o},reach:{value:1.6*n}}}),s&&(this.cast=new en(s.geometry,this.shade),this.cast.frustumCulled=!1,this.scene.add(this.cast))}colours(e){let{line:t,dark:n,strength:s,opacity:r}=this.mesh.material.uniforms;e?t.value.set(.62,.68,.78):t.value.set(.36,.42,.52),e?n.value.set(0,0,.01):n.value.set(.1,.12,.2),s.value=e?.62:.34,r.value=e?.2:.26}shadow(e,t,n){this.cast&&(this.cast.geometry=t.geometry,this.shade.uniforms.scale.value=n,e.setRenderTarget(this.target),e.clear(),e.render(this.scene,this.camera),e.setRenderTarget(null))}dispose(){this.target.dispose(),this.mesh.geometry.dispose(),this.mesh.material.dispose(),this.shade.dispose()}};var Mx=new fn,Ru=class{constructor(e,t,n,s){this.connection=e;this.size=t;this.stiffness=n;this.flat=s;this.radius=.16*t,this.deep=.5*t}connection;size;stiffness;flat;action="free";point=-1;target=new F;radius;deep;edge=new F;turned=new fn;local=new F;plane=new yi;offset=new F;pressed=0;goal(e){return this.action!=="pose"?e.copy(this.target):e.copy(this.local).applyQuaternion(this.turned).add(this.target)}get holds(){return this.action!=="free"}grab(e,t,n,s,r,o="grab"){this.action=o,this.point=e,this.plane.setFromNormalAndCoplanarPoint(s,n),this.offset.subVectors(t,n),this.target.copy(t),this.send(r)}lead(e,t,n,s,r,o){this.turned.copy(n),this.local.subVectors(s,t).applyQuaternion(Mx.copy(n).invert()),this.grab(e,t,s,r,o,"pose")}turn(e,t,n){this.action==="pose"&&(this.turned.premultiply(Mx.setFromAxisAngle(e,t)).normalize(),this.send(n))}rebase(e){let t=e.intersectPlane(this.plane,new F);t&&this.offset.subVectors(this.target,t)}press(e,t,n){this.action="ball",this.point=-1,this.pressed=0,this.offset.copy(t).multiplyScalar(-this.radius),this.target.copy(e).add(this.offset),this.plane.setFromNormalAndCoplanarPoint(t,e),this.send(n)}cut(e,t,n){this.action="blade",this.point=-1;let s=.08*this.size;this.offset.copy(t).multiplyScalar(-s),this.target.copy(e).add(this.offset),this.edge.copy(t).multiplyScalar(this.deep+s),this.plane.setFromNormalAndCoplanarPoint(t,e),this.send(n)}deepen(e){let t=this.deep;if(this.deep=Math.min(Math.max(t*e,.05*this.size),2.5*this.size),this.action!=="blade")return;let n=.08*this.size;this.edge.setLength(this.deep+n),this.send()}push(e,t){if(this.action!=="ball"||this.pressed>=1)return!1;let n=Math.min(e/.35,1-this.pressed);return this.pressed+=n,this.shift(t.clone().multiplyScalar(n*this.radius)),!0}follow(e,t){let n=e.intersectPlane(this.plane,new F);!n||!this.holds||(this.target.copy(n).add(this.offset),this.limit(),this.send(t))}depth(e,t){this.holds&&!this.flat&&this.shift(t.clone().multiplyScalar(e))}shift(e){this.holds&&(this.offset.add(e),this.target.add(e),this.limit(),this.send())}release(e){this.holds&&(this.action="free",this.point=-1,this.send(e))}send(e){this.connection.point({action:this.action,point:Math.max(this.point,0),target:this.target.toArray(),radius:this.action==="ball"?this.radius:0,stiffness:this.stiffness,time:e,edge:this.action==="blade"?this.edge.toArray():this.action==="pose"?EC(this.turned):[0,0,0]})}limit(){this.flat&&(this.target.z=0);let e=this.target.length();e>50*this.size&&this.target.multiplyScalar(50*this.size/e)}};function EC({x:i,y:e,z:t,w:n}){let s=Math.hypot(i,e,t),r=(s<1e-12?2:2*Math.atan2(s,Math.abs(n))/s)*(n<0?-1:1);return[r*i,r*e,r*t]}var Sl=class i{element=document.createElement("div");taken=[];made=new Map;used=new Set;since=0;count=!0;constructor(e){this.element.className="ct-labels",this.element.setAttribute("aria-hidden","true"),e.append(this.element)}static wide(e,t){return 7.1*(e.length+t.length)+52}put(e,t,n,s,r,o,a){let l=this.made.get(e)??this.make(e);this.used.add(e);let c=`ct-label ct-${t}`;l.element.className!==c&&(l.element.className=c),l.slot!==n&&l.element.style.setProperty("--user",`var(--user-${(l.slot=n)%8})`),l.text.textContent!==s&&(l.text.textContent=s);let h=l.detail.textContent;h!==r&&(this.count||!h||!r)&&(l.detail.textContent=r),t==="hand"&&(a=this.clear(o,a,i.wide(s,r)));let u=`translate(${o.toFixed(1)}px, ${a.toFixed(1)}px)`;l.place!==u&&(l.element.style.transform=l.place=u)}make(e){let t=document.createElement("div"),[n,s]=[document.createElement("b"),document.createElement("span")];t.append(n,s),this.element.append(t);let r={element:t,text:n,detail:s,slot:-1,place:""};return this.made.set(e,r),r}clear(e,t,n){for(let s=0;s<6;s++){let r=this.taken.find(o=>e<o.x+o.wide&&o.x<e+n&&Math.abs(t-o.y)<24);if(!r)break;t=r.y-24}return this.taken.push({x:e,y:t,wide:n}),t}sweep(){this.taken.length=0;for(let[t,n]of this.made)this.used.has(t)||(n.element.remove(),this.made.delete(t));this.used.clear();let e=performance.now();this.count=e-this.since>=125,this.count&&(this.since=e)}};function Sx(i,e,t,n){if(!n||i.length<2)return[{slot:i[0]??0,x:0,y:0,width:e,height:t}];let s=e>=t,r=i.length-1,o=r===1?.5:.48,a=s?{slot:i[0],x:0,y:0,width:Math.round(e*o)-6/2,height:t}:{slot:i[0],x:0,y:0,width:e,height:Math.round(t*o)-6/2},[l,c]=s?[a.width+6,0]:[0,a.height+6],[h,u]=[e-l,t-c],d=1,f=0;for(let g=1;g<=r;g++){let v=Math.min(h/g,u/Math.ceil(r/g));v>f&&([f,d]=[v,g])}let m=Math.ceil(r/d),[y,p]=[(h-6*(d-1))/d,(u-6*(m-1))/m];return[a,...i.slice(1).map((g,v)=>({slot:g,x:Math.round(l+v%d*(y+6)),y:Math.round(c+Math.floor(v/d)*(p+6)),width:Math.round(y),height:Math.round(p)}))]}var kp=1.54,TC=1.15,Iu=class{constructor(e,t,n,s,r=[1.2,1.42]){this.size=t;this.cloud=n;this.room=r;this.camera.up.set(0,0,1),this.camera.near=t*.02,this.camera.far=t*60,this.home={target:e.clone(),yaw:s?-Math.PI/2:-1.08,pitch:s?kp:.36,zoom:1},this.goal=Pu(this.home),this.now=Pu(this.home)}size;cloud;room;camera=new Qn(30,1,.01,100);home;goal;now;fit=1;fits=new Map;aspect(e,t){this.camera.aspect=e/Math.max(t,1),this.fit=this.fitted(this.camera.aspect),this.camera.updateProjectionMatrix(),this.apply()}fitted(e){let t=e.toFixed(3),n=this.fits.get(t);if(n)return n;let{target:s}=this.home,r=Bp(this.home),o=new F(0,0,1).cross(r).normalize(),a=r.clone().cross(o),l=new F,c=Math.tan(this.camera.fov*Math.PI/360),h=3*Math.max(1,Math.floor(this.cloud.length/3/500)),u=.5*this.size;for(let d=0;d<this.cloud.length;d+=h)l.fromArray(this.cloud,d).sub(s),u=Math.max(u,l.dot(r)+this.room[e<1?0:1]*Math.max(Math.abs(l.dot(o))/e,1.12*Math.abs(l.dot(a)))/c);return this.fits.set(t,u),u}turn(e,t){this.goal.yaw-=e*.0065,this.goal.pitch=Math.min(Math.max(this.goal.pitch+t*.0065,-kp),kp)}zoom(e){let t=this.nearest(this.goal)/this.fit;this.goal.zoom=Math.min(Math.max(Math.max(this.goal.zoom,t)*e,t,.12),Math.max(6,t))}pan(e,t,n){let s=this.metres(n),[r,o]=this.axes();this.goal.target.addScaledVector(r,-e*s).addScaledVector(o,t*s)}reset(){this.goal=Pu(this.home)}metres(e){return 2*Math.tan(this.camera.fov*Math.PI/360)*Math.max(this.now.zoom*this.fit,this.nearest(this.now))/Math.max(e,1)}axes(){let e=new F,t=new F,n=new F;return this.camera.updateMatrixWorld(),this.camera.matrixWorld.extractBasis(e,t,n),[e,t,n.negate()]}step(e){let{now:t,goal:n}=this,s=Math.abs(n.yaw-t.yaw)+Math.abs(n.pitch-t.pitch)+Math.abs(Math.log(n.zoom/t.zoom))+n.target.distanceTo(t.target)/this.size;if(s===0)return!1;let r=s<.001?1:e;return r<1?(t.yaw+=(n.yaw-t.yaw)*r,t.pitch+=(n.pitch-t.pitch)*r,t.zoom*=(n.zoom/t.zoom)**r,t.target.lerp(n.target,r)):this.now=Pu(n),this.apply(),!0}nearest(e){let t=e.target.clone().sub(this.home.target),n=t.dot(Bp(e)),s=(TC*this.size)**2-t.lengthSq()+n**2;return s>0?Math.sqrt(s)-n:0}apply(){let{target:e,zoom:t}=this.now,n=Math.max(t*this.fit,this.nearest(this.now));this.camera.position.copy(Bp(this.now)).multiplyScalar(n).add(e),this.camera.lookAt(e),this.camera.updateMatrixWorld()}};function Bp({yaw:i,pitch:e}){return new F(Math.cos(i)*Math.cos(e),Math.sin(i)*Math.cos(e),Math.sin(e))}function Pu(i){return{...i,target:i.target.clone()}}var wx=new Bs(1,28,18),zp=Ii()?new Bs(1,10,7):new Bs(1,18,12),Lu=new Dr(1,1,1,Ii()?6:12,1,!0).translate(0,.5,0),AC=new Ka(1,1,Ii()?10:18).translate(0,.5,0),CC=Ii()?new qo(1,.13,5,20):new qo(1,.13,8,36),RC=new Dr(.12,1,1,12).translate(0,.5,0),PC=new F(0,1,0),Gr=new F,IC=new F,LC=new fn;function Gs(i,e=1){let t=new Bn({defines:oa(),vertexShader:Np.vertex,fragmentShader:Np.fragment,uniforms:{colour:{value:new F},opacity:{value:e}},transparent:e<1,depthWrite:e>=1});return Hs(t,i),t}function Hs(i,e){let[t,n,s]=es(e);i.uniforms.colour.value.set(t/255,n/255,s/255)}function aa(i,e,t,n){Gr.subVectors(t,e);let s=Gr.length();i.visible=s>1e-9,i.visible&&(i.position.copy(e),i.quaternion.copy(LC.setFromUnitVectors(PC,Gr.divideScalar(s))),i.scale.set(n,s,n))}var Nu=class{constructor(e,t,n,s={least:.08,longest:.8}){this.size=e;this.full=t;this.arrow=s;this.skin=Gs(n),this.cord=Gs(n),this.glass=Gs(n,.55);for(let o of[this.skin,this.cord,this.glass]){let a=Gs(n,.2);a.depthFunc=Do,a.uniforms.colour=o.uniforms.colour,this.hidden.set(o,a)}let r=(o,a)=>{let l=new en(o,a);if(l.frustumCulled=!1,this.group.add(l),Ii())return l;let c=new en(o,this.hidden.get(a));return c.frustumCulled=!1,c.renderOrder=20,l.add(c),l};this.proxy=r(zp,this.skin),this.knot=r(zp,this.skin),this.rope=r(Lu,this.cord),this.lead=r(Lu,this.cord),this.shaft=r(Lu,this.skin),this.head=r(AC,this.skin),this.mark=r(CC,this.skin),this.blade=r(RC,this.skin),this.stem=r(Lu,this.glass),this.end=r(wx,this.glass),this.group.visible=!1}size;full;arrow;group=new ei;spot=new F;force=0;skin;cord;glass;hidden=new Map;proxy;knot;rope;lead;shaft;head;mark;blade;stem;end;tip=new F;neck=new F;paint(e){Hs(this.skin,e),Hs(this.glass,e)}pose(e,t){let{size:n}=this,s=this.force=e.force.length();this.spot.copy(e.proxy);let r=Math.min(s/this.full,1),o=n*(.006+.012*r);Hs(this.cord,Ca(r,!1)),this.proxy.material=e.radius>0?this.glass:this.skin,this.proxy.geometry=e.radius>0?wx:zp,this.proxy.position.copy(e.proxy),this.proxy.scale.setScalar(e.radius>0?e.radius:n*.042);let a=e.edge.lengthSq()>0,l=a&&e.radius===0;if(this.knot.visible=e.radius===0&&!l,this.tip.addVectors(e.place,e.edge),aa(this.blade,e.place,this.tip,n*.024),aa(this.stem,e.place,this.tip,e.radius),this.blade.visible=l,this.stem.visible=this.end.visible=a&&!l,this.end.position.copy(this.tip),this.end.scale.setScalar(e.radius),this.knot.position.copy(e.place),this.knot.scale.setScalar(n*.026),aa(this.rope,e.place,e.proxy,o),aa(this.lead,e.proxy,e.target,o*.8),(e.radius>0||l)&&(this.rope.visible=!1),this.mark.visible=e.pointed,this.mark.position.copy(e.target),this.mark.quaternion.copy(t),this.mark.scale.setScalar(n*.045),this.shaft.visible=this.head.visible=r>.01&&!e.pointed,!this.shaft.visible)return;Gr.copy(e.force).divideScalar(s);let c=(e.arrow?.6:1)*n*(this.arrow.least+(this.arrow.longest-this.arrow.least)*r),h=Math.min(.09*n,.6*c),u=IC.copy(e.arrow??(e.radius>0?e.proxy:e.place));e.arrow&&u.addScaledVector(Gr,-c),this.tip.copy(u).addScaledVector(Gr,c),this.neck.copy(u).addScaledVector(Gr,c-h);let[d,f]=[this.tip,this.neck];aa(this.shaft,u,f,.145*h),aa(this.head,f,d,.4*h)}dispose(){for(let e of[this.skin,this.cord,this.glass,...this.hidden.values()])e.dispose()}};var NC=new F(0,0,1),Ax=1-1e-6,Ex=6,DC=300,FC=48,Tx=30;function Cx({normal:i}){return new F(...i).normalize()}function Rx(i){let e=i.flatMap(t=>t.kind==="plane"&&Cx(t).z>Ax?[t.point[2]]:[]);return e.length?Math.max(...e):null}function Px(i,e,t,n){let s=e.flatMap(o=>{if(o.kind==="plane")return[];if(o.kind==="solid")return UC(o,t,Ex*n);if(t.distanceTo(new F(...o.centre))>Ex*n)return[];let a=Ix(o);return Array.from({length:8},(l,c)=>new F(...o.size.map((u,d)=>(c>>d&1?.5:-.5)*u)).applyQuaternion(a).add(new F(...o.centre)).toArray()).flat()}),r=3*Math.max(1,Math.ceil(i.length/3/DC));return s.length?Float32Array.from([...s,...i.filter((o,a)=>a%r<3)]):i}function UC({vertices:i},e,t){let n=new fs().setFromArray(i);if(n.getCenter(new F).distanceTo(e)>t)return[];let s=[n.min.toArray(),n.max.toArray()];return Array.from({length:8},(r,o)=>[0,1,2].map(a=>s[o>>a&1][a])).flat()}function OC({vertices:i,triangles:e}){let t=new pn;t.setAttribute("position",new Mn(Float32Array.from(i),3)),t.setIndex(e);let n=t.toNonIndexed();return n.computeVertexNormals(),t.dispose(),n}function Ix({turn:i}){let e=new F(...i);return new fn().setFromAxisAngle(e.clone().normalize(),e.length())}function kC(i,[e,t,n]){let[s,r]=[.5*i[0],.5*i[1]],o=new Wo().moveTo(-s,-r).lineTo(s,-r).lineTo(s,r).lineTo(-s,r).closePath();return o.holes.push(new Fr().absarc(t,n,e,0,2*Math.PI,!0)),new sl(o,{depth:i[2],bevelEnabled:!1,curveSegments:FC}).translate(0,0,-.5*i[2])}var Du=class{group=new ei;solid=Gs("#ffffff");sheet=Gs("#ffffff",.3);line=new zo({transparent:!0,opacity:.5});made=[];constructor(e,t,n){this.sheet.side=2;for(let s of e){if(s.kind==="plane"){let o=Cx(s);if(o.z>Ax)continue;let a=new en(this.keep(new ks(5*n,5*n)),this.sheet);a.position.copy(t).addScaledVector(o,new F(...s.point).sub(t).dot(o)),a.quaternion.setFromUnitVectors(NC,o),a.renderOrder=-1,this.group.add(a);continue}if(s.kind==="solid"){let o=this.keep(OC(s));this.group.add(new en(o,this.solid),new Us(this.keep(new Go(o,Tx)),this.line));continue}let r=this.keep(s.kind==="plate"?kC(s.size,s.hole):new cr(...s.size));for(let o of[new en(r,this.solid),new Us(this.keep(new Go(r,Tx)),this.line)])o.position.set(...s.centre),o.quaternion.copy(Ix(s)),this.group.add(o)}}colours(e){Hs(this.solid,e?"#4A5464":"#CBD2DC"),Hs(this.sheet,e?"#8C98AA":"#7C8899"),this.line.color.set(e?"#9AA6B8":"#5C6878")}dispose(){for(let e of[this.solid,this.sheet,this.line,...this.made])e.dispose()}keep(e){return this.made.push(e),e}};var Lx=900,Nx=46,Fu=matchMedia("(prefers-reduced-motion: reduce)");function Dx(i,e,t,n,s){return new Vp(i,e,t,n,s)}function BC(i){i.readPixels(0,0,1,1,i.RGBA,i.UNSIGNED_BYTE,new Uint8Array(4))}var Vp=class{constructor(e,t,n,s,r){this.scene=t;this.store=n;this.connection=s;this.stats=r;let o=t.radius||1,a=t.dimension<3;this.renderer=new fu({antialias:!Ii(),alpha:!0,powerPreference:"high-performance"}),this.renderer.setClearAlpha(0),this.renderer.autoClear=!1,this.canvas=this.renderer.domElement,this.canvas.className="ct-canvas",this.canvas.tabIndex=0,this.canvas.setAttribute("role","application"),this.canvas.setAttribute("aria-label","The shared object. Drag it to pull; G grabs, arrows move, Escape lets go."),e.append(this.canvas),this.shape=new wu(t),this.common=new Tu(o,this.shape);let l=new F(...t.centre);this.orbit=new Iu(l,o,Px(t.points,t.obstacles,l,o),a),this.full=.6*t.stiffness*o,this.hold=new Ru(s,o,t.stiffness,a);for(let{slot:m}of t.users){let y=new Au(m,this.shape,this.common),p=new Nu(o,this.full,wi(m,!1));this.copies.set(m,y),this.hands.set(m,p),this.world.add(y.group,p.group)}let c=1/0;for(let m=2;m<t.points.length;m+=3)c=Math.min(c,t.points[m]);this.ground=new Cu(l,c,o,t.skin?this.mine.moving:null,Rx(t.obstacles)),this.obstacles=new Du(t.obstacles,l,o),this.ground.mesh.visible=!a,this.dot=new en(new Bs(.022*o,20,14),this.dotPaint),this.dot.visible=!1,this.world.add(this.ground.mesh,this.obstacles.group,this.dot),this.labels=new Sl(e);let u=t.parts.some(({tool:m})=>m&&t.own.includes(m.slot))?"Drag your tool to move it; hold Shift to turn it. Drag beside it to look around.":"Grab the object and pull. Drag beside it to look around.";this.furniture=new yo(e,n,{act:u,look:"Drag to look around, and scroll to zoom."}),this.touch=new vu(this,n);let d=new ResizeObserver(()=>this.resize());d.observe(e);let f=()=>this.dress();this.ends.push(()=>d.disconnect(),eo(f),n.on("settings",f),n.on("slot",()=>{this.touch.release(),this.dress()}),n.on("frame",()=>this.draw()),n.on("state",()=>{for(let[m,y]of this.copies)y.moving.cut(this.store.state?.members[m]?.cut??null);this.draw()}),n.on("connection",()=>{n.connection==="open"&&this.hold.holds&&this.hold.send()})),this.resize(),this.dress()}scene;store;connection;stats;canvas;orbit;hold;renderer;world=new Lr;shape;common;copies=new Map;hands=new Map;ground;obstacles;dot;dotPaint=Gs("#ffffff");labels;furniture;touch;ends=[];full;face=new fn;proxy=new F;place=new F;goal=new F;aimed=new F;posed={place:new F,proxy:new F,target:new F,force:new F,radius:0,edge:new F,arrow:null,pointed:!1};back=new ps;out=new F;fresh=!0;hovered=null;area=[];width=0;height=0;shown=null;dirty=!0;came=0;shadowed={by:-1,left:0};last=0;handle=0;peak=0;pulsed={slot:-1,since:-1/0};quality=new _u(()=>Math.min(devicePixelRatio||1,2));reset(){this.orbit.reset(),this.draw()}pulse(e){this.pulsed={slot:e,since:performance.now()},this.draw()}spot(e){let t=this.area[0],n=e??this.pick(t.x+t.width/2,t.y+t.height/2,t.width)?.point;if(n===void 0)return null;let s=yu(this.orbit.camera,t,new F().fromArray(this.mine.moving.places,3*this.shape.corner[n]));return s&&{...s,point:n}}probe(){let e=this.canvas.getBoundingClientRect(),t=yu(this.orbit.camera,this.area[0],this.hold.target);return{space:this,hold:this.hold,orbit:this.orbit,target:t&&[t.x+e.left,t.y+e.top]}}dispose(){cancelAnimationFrame(this.handle),this.handle=-1,this.touch.dispose();for(let e of this.ends)e();for(let e of[...this.copies.values(),...this.hands.values(),this.ground,this.obstacles,this.dotPaint,this.dot.geometry,this.furniture])e.dispose();this.renderer.dispose(),this.renderer.forceContextLoss(),this.canvas.remove(),this.labels.element.remove()}ownCell(){return this.area[0]}cellAt(e,t){return this.area.find(n=>e>=n.x&&e<n.x+n.width&&t>=n.y&&t<n.y+n.height)??this.area[0]}pick(e,t,n){if(this.cellAt(e,t)!==this.area[0])return null;let s=gu(this.mine.moving,this.orbit.camera,this.area[0],e,t,n),r=s&&this.toolAt(s.point);return r&&r.slot!==this.store.slot?null:s}take(e,t,n){let s=this.toolAt(e.point);if(s){let{handle:r,turned:o}=Op(s,this.shape.rest,this.mine.moving.places);this.hold.lead(e.point,r,o,e.surface,t,n)}else this.store.tool==="ball"?this.hold.press(e.surface,t,n):this.store.tool==="blade"?this.hold.cut(e.surface,t,n):this.hold.grab(e.point,e.place,e.surface,t,n)}toolAt(e){return this.shape.tools.find(({first:t,last:n})=>e>=t&&e<n)}aim(e,t){let n=this.canvas.getBoundingClientRect(),s=this.cellAt(e-n.left,t-n.top),r=(this.copies.get(s.slot)??this.mine).moving,o=ia(this.orbit.camera,s,e-n.left,t-n.top),a=gu(r,this.orbit.camera,s,e-n.left,t-n.top,0),l=a??gu(r,this.orbit.camera,s,e-n.left,t-n.top,1/0);if(!l)return null;let c=this.orbit.camera.getWorldDirection(new F),h=a?.surface??o.at(l.place.clone().sub(o.origin).dot(c)/o.direction.dot(c),new F);return{point:l.point,to:[h.x,h.y,h.z]}}hover(e){e?.point!==this.hovered?.point&&this.draw(),this.hovered=e;let t=e?this.store.tool:"";this.canvas.dataset.over!==t&&(this.canvas.dataset.over=t)}mayAct(){return this.connection.mayAct}force(){return Math.min(this.pull()/this.full,1)}draw(){this.dirty=!0,this.handle||(this.handle=requestAnimationFrame(e=>this.tick(e)))}get mine(){return this.copies.get(this.store.slot)??this.copies.values().next().value}get side(){return this.store.settings.layout==="side"}pull(){if(!this.hold.holds||this.fresh)return 0;let e=this.shown?.copies.find(t=>t.slot===this.store.slot);return this.hold.action!=="grab"?e?.mode===this.hold.action?Math.hypot(...e.force):0:this.scene.stiffness*this.place.distanceTo(this.hold.target)}resize(){let e=this.canvas.parentElement?.getBoundingClientRect();!e||e.width<1||e.height<1||(this.width=Math.round(e.width),this.height=Math.round(e.height),this.renderer.setPixelRatio(this.quality.ratio),this.renderer.setSize(this.width,this.height),this.arrange(),this.shown&&this.render(performance.now()),this.draw())}arrange(){let e=this.scene.users.map(n=>n.slot).filter(n=>n!==this.store.slot),t=this.side&&this.height>3*Nx?Nx:0;this.area=Sx([this.store.slot,...e],this.width,this.height-t,this.side);for(let n of this.area)n.y+=t;this.furniture.rules(this.area.length>1?this.area:[])}dress(){let{settings:e}=this.store,t=Ks(e.theme),n={displacement:0,stress:1,plain:2}[this.store.colour];n!==this.common.by.value&&(this.peak=0),this.common.by.value=n;for(let[s,r]of this.copies)r.paint(wi(s,t),t),r.against(this.mine.moving),this.hands.get(s).paint(wi(s,t));Hs(this.dotPaint,t?"#FFFFFF":"#111827"),this.ground.colours(t),this.obstacles.colours(t),this.arrange(),this.shown=null,this.draw()}tick(e){this.handle=0;let t=Math.min((e-this.last)/1e3,.1);this.last=e;let n=this.store.frame!==null&&this.store.frame!==this.shown,s=this.store.came-this.came-1;n&&(this.came=this.store.came,this.show(this.store.frame));let r=this.orbit.step(Fu.matches?1:1-Math.exp(-t*18));r=this.touch.step(t)||r,r=this.haptic(t)||r,r=this.range(t)||r,r=e-this.pulsed.since<Lx||r,(this.dirty||r)&&(this.dirty=!1,this.render(e),n&&(this.stats.finishing&&BC(this.renderer.getContext()),this.stats.drew(this.shown.echo,this.shown.received,performance.now()),this.quality.took(s,t)&&this.resize())),r&&this.draw()}show(e){this.shown=e,this.common.scale.value=e.scale;let t=this.side||this.store.settings.ghosts,n=this.common.by.value===1,s=0;for(let{slot:r,displacement:o}of e.copies){let a=this.copies.get(r);!a||!(t||a===this.mine)||(a.moving.update(o,e.scale,n&&(this.side||a===this.mine)),(this.side||a===this.mine)&&(s=Math.max(s,a.moving.peak)))}this.peak=Math.max(s,this.peak*.998)}haptic(e){if(!this.hold.holds)return!(this.fresh=!0);let{moving:t}=this.mine,n=this.hold.action==="pose"?this.toolAt(this.hold.point):void 0;if(this.hold.action==="grab")this.place.fromArray(t.places,3*this.shape.corner[this.hold.point]);else if(n){let{handle:c,turned:h}=Op(n,this.shape.rest,t.places);this.place.copy(this.hold.local).applyQuaternion(h).add(c)}else{let c=this.shown?.copies.find(h=>h.slot===this.store.slot);c?.mode===this.hold.action?this.place.fromArray(c.place):this.place.copy(this.hold.target)}let s=this.hold.goal(this.aimed),r=this.force(),a=this.hold.action==="grab"||this.hold.action==="pose"?.6*r/(r+.45):1,l=this.goal.lerpVectors(s,this.place,a);return this.fresh||Fu.matches?this.proxy.copy(l):this.proxy.lerp(l,1-Math.exp(-e*55)),this.fresh=!1,this.proxy.distanceTo(l)>1e-4*this.scene.radius}range(e){let t=this.common.by.value===1,n=go(Math.max(this.peak,t?.02:.04*this.scene.radius));this.furniture.legend(this.store.colour,t?`${Math.round(n*100)} %`:oc(n));let{full:s}=this.common;return s.value+=(n-s.value)*(Fu.matches?1:1-Math.exp(-e*6)),Math.abs(s.value-n)>.01*n}render(e){let{renderer:t,common:n}=this,[,,s]=this.orbit.axes();this.orbit.camera.getWorldQuaternion(this.face),t.setScissorTest(!1),t.setViewport(0,0,this.width,this.height),t.clear();for(let r of this.area){this.orbit.aspect(r.width,r.height);let o=this.copies.get(r.slot)??this.mine,a=this.shown?.copies;for(let[c,h]of this.copies){let u=!a||a.some(f=>f.slot===c),d=!this.side&&this.store.settings.ghosts&&u&&a;h.show(h===o?"solid":d?"ghost":"hidden",this.flash(c,e)),h.thin(this.mine.moving,this.orbit.camera.position,n.apart.value),h.order(s)}for(let[c,h]of this.hands)h.group.visible=(!this.side||c===r.slot)&&this.pose(c,h);this.dot.visible=!!this.hovered&&r===this.area[0],this.hovered&&this.dot.position.fromArray(this.mine.moving.places,3*this.shape.corner[this.hovered.point]),(this.side||o.slot!==this.shadowed.by||--this.shadowed.left<=0)&&(this.ground.shadow(t,o.moving,n.scale.value),this.shadowed={by:o.slot,left:this.quality.shadows}),n.height.value=r.height*this.quality.ratio;let l=this.height-r.y-r.height;t.setScissorTest(!0),t.setScissor(r.x,l,r.width,r.height),t.setViewport(r.x,l,r.width,r.height),t.render(this.world,this.orbit.camera),t.setScissorTest(!1),this.name(r)}this.orbit.aspect(this.area[0].width,this.area[0].height),this.labels.sweep()}flash(e,t){let n=(t-this.pulsed.since)/Lx;return e!==this.pulsed.slot||n>=1||n<0?0:Fu.matches?.6:Math.sin(n*Math.PI*3)**2*(1-n)}pose(e,t){let n=this.posed;if(e===this.store.slot&&this.hold.holds){let r=this.pull();return n.place.copy(this.place),n.proxy.copy(this.proxy),this.hold.goal(n.target),n.force.subVectors(n.target,n.place).setLength(r),n.radius=this.hold.action==="ball"?this.hold.radius:0,this.hold.action==="blade"?n.edge.copy(this.hold.edge):n.edge.set(0,0,0),n.arrow=null,n.pointed=!0,t.pose(n,this.face),!0}let s=this.shown?.copies.find(r=>r.slot===e);return!s?.hasHand||s.mode==="free"||s.node<0&&s.radius===0&&s.mode!=="pose"&&!s.edge.some(Boolean)&&!s.force.some(Boolean)?!1:(n.place.fromArray(s.place),n.target.fromArray(s.target),n.force.fromArray(s.force),n.edge.fromArray(s.edge),n.proxy.copy(s.radius>0||s.edge.some(Boolean)?n.place:n.target),n.radius=s.radius,n.arrow=s.radius===0&&s.node<0&&!s.edge.some(Boolean)?this.behind(e,n):null,n.pointed=!1,t.pose(n,this.face),!0)}behind(e,{place:t,force:n}){if(!n.lengthSq())return null;this.back.set(t,this.back.direction.copy(n).negate().normalize());let s=this.copies.get(e)?.moving.places;for(let r of this.shape.tools)if(s&&r.slot===e&&xx(r,this.back,s,this.out))return this.out;return null}name(e){let{slot:t,me:n,state:s}=this.store,r=o=>this.scene.users.find(a=>a.slot===o)?.name??`User ${o+1}`;if(this.side){let o=s?rc(s,t).get(e.slot):0,a=this.shown?.copies.find(u=>u.slot===e.slot),l=s?.members[e.slot]?.here===!1||!a,c=a&&!a.direct?`, shown ${cs(a.age)} old`:"",h=e.slot===n?"you":e.slot===t?"":l?"not here":o===void 0?`out of reach${c}`:e.width<240?`+${cs(o)}`:n===null?`${cs(o)} after ${r(t)}${c}`:`feels you ${cs(o)} later${c}`;this.labels.put(`cell${e.slot}`,"title",e.slot,r(e.slot),h,e.x+14,e.y+12)}for(let[o,a]of this.hands){if(!a.group.visible)continue;let l=yu(this.orbit.camera,e,a.spot);if(!l||l.x<e.x||l.x>e.x+e.width||l.y<e.y||l.y>e.y+e.height)continue;let c=a.force>.005*this.full?ac(a.force):"";if(this.side&&!c)continue;let h=this.side?"":o===n&&this.hold.holds?"You":r(o),u=Sl.wide(h,c);l.x=Math.max(Math.min(l.x,e.x+e.width-u),e.x);let d=this.side?0:this.furniture.covered(l.x,l.x+u,e.width);l.y=Math.max(Math.min(l.y,e.y+e.height+9-d),e.y+34),this.labels.put(`hand${o}`,"hand",o,h,c,l.x,l.y)}}};var zC="The picture needs WebGL 2, which this browser does not provide; everything else works.";function Fx(i,e,t,n){let s=null,r="",o=()=>{let l=e.scene;if(!(!l||l.started===r)){r=l.started,s?.dispose(),s=null,i.classList.add("ct-stage");try{s=(l.dimension===1?dx:Dx)(i,l,e,t,n)}catch(c){i.replaceChildren(Object.assign(document.createElement("p"),{className:"ct-sorry",textContent:zC})),console.warn(c)}}},a=e.on("scene",o);return o(),{reset:()=>s?.reset(),probe:()=>s?.probe?.()??{},spot:l=>{let c=s?.spot(l),h=i.getBoundingClientRect();return c?{...c,x:c.x+h.left,y:c.y+h.top}:null},pulse:l=>s?.pulse(l),aim:(l,c)=>s?.aim(l,c)??null,dispose:()=>{a(),s?.dispose()}}}var Uu=class{finishing=!1;frames=0;fps=0;dragToMesh=[];echoMs=[];waiting=[];since=0;counted=0;pointed(e,t){this.waiting.push({number:e,time:t}),this.waiting.length>600&&this.waiting.shift()}drew(e,t,n){for(this.frames++,this.counted++,n-this.since>=1e3&&(this.fps=this.counted*1e3/(n-this.since),this.since=n,this.counted=0);this.waiting.length&&this.waiting[0].number<=e;){let{time:s}=this.waiting.shift();Ux(this.dragToMesh,n-s),Ux(this.echoMs,t-s)}}};function Ux(i,e){i.push(e),i.length>600&&i.shift()}var Ox=["x","y","z","force","energy","supplied","lost","linked"],Ou=class{seconds=20;capacity=1240;count=0;version=0;next=0;times=new Float64Array(1240);tracks=new Map;get slots(){return[...this.tracks.keys()].sort((e,t)=>e-t)}clear(){this.count=this.next=0,this.tracks=new Map,this.version++}add(e){let t=this.next;if(this.count&&e.time<this.times[(t+1240-1)%1240])return;for(let s of this.tracks.values())for(let r of Ox)s[r][t]=NaN;let n=Math.max(1,Math.floor(e.points/1500));for(let s of e.copies){let r=this.track(s.slot),o=s.displacement,a=0,l=0,c=0,h=0;for(let d=0;d<e.points;d+=n,h++)a+=o[3*d],l+=o[3*d+1],c+=o[3*d+2];let u=e.scale/Math.max(h,1);r.x[t]=a*u,r.y[t]=l*u,r.z[t]=c*u,r.force[t]=Math.hypot(...s.force),r.energy[t]=s.energy,r.supplied[t]=s.supplied,r.lost[t]=s.lost,r.linked[t]=s.linked}this.times[t]=e.time,this.next=(t+1)%1240,this.count=Math.min(this.count+1,1240),this.version++}time(){return this.ordered(this.times,new Float64Array(this.count))}series(e,t){let n=this.tracks.get(t),s=new Float32Array(this.count);if(!n)return s.fill(NaN);if(e!=="displacement")return this.ordered(n[e],s);let[r,o,a]=["x","y","z"].map(l=>this.ordered(n[l],new Float32Array(this.count)));return s.map((l,c)=>Math.hypot(r[c],o[c],a[c]))}before(e,t){let n=this.tracks.get(e);if(!n||!this.count)return NaN;let s=l=>(this.next-1-l+2*1240)%1240,r=this.times[s(0)]-t,o=0,a=this.count-1;for(;o<a;){let l=o+a>>1;this.times[s(l)]>r?o=l+1:a=l}return n.x[s(o)]}ordered(e,t){let n=(this.next-this.count+1240)%1240,s=Math.min(this.count,1240-n);return t.set(e.subarray(n,n+s)),t.set(e.subarray(0,this.count-s),s),t}track(e){let t=this.tracks.get(e);return t||(t=Object.fromEntries(Ox.map(n=>[n,new Float32Array(1240).fill(NaN)])),this.tracks.set(e,t)),t}};var kx={layout:"overlay",colour:"auto",theme:"auto",tool:"grab",ghosts:!0},Bx="cotouch.settings",VC=3;function GC(){try{return{...kx,...JSON.parse(localStorage.getItem(Bx)??"{}")}}catch{return{...kx}}}var ku=class{scene=null;state=null;frame=null;came=0;connection="connecting";refusal="";slot=0;history=new Ou;settings=GC();listeners=new Map;wished;constructor(e=null){this.wished=e,e!==null&&(this.slot=e)}get colour(){let{colour:e}=this.settings;return e!=="auto"?e:this.scene?.parts.length?"plain":"displacement"}get stalled(){return this.connection==="open"&&!this.state?.ended&&(this.state?.age??0)>VC}get tools(){return this.scene?.cutting?["grab","ball","blade"]:["grab","ball"]}get tool(){return this.tools.includes(this.settings.tool)?this.settings.tool:"grab"}get me(){return this.scene?.acts&&this.scene.own.includes(this.slot)?this.slot:null}get live(){return this.connection==="open"&&!this.state?.ended&&!this.stalled}on(e,t){let n=this.listeners.get(e)??new Set;return this.listeners.set(e,n.add(t)),()=>n.delete(t)}emit(e){for(let t of[...this.listeners.get(e)??[]])t()}set(e){this.settings={...this.settings,...e};try{localStorage.setItem(Bx,JSON.stringify(this.settings))}catch{}this.emit("settings")}take(e){e!==this.slot&&(this.slot=this.wished=e,this.emit("slot"))}show(e){this.scene?.started!==e.started&&(this.state=this.frame=null,this.history.clear()),this.scene=e;let t=e.users.map(r=>r.slot),n=this.wished!==null&&t.includes(this.wished)?this.wished:e.own[0]??t[0]??0,s=n!==this.slot;this.slot=n,this.emit("scene"),s&&this.emit("slot")}told(e){this.state=e,this.emit("state")}drawn(e){this.frame=e,this.came++,this.history.add(e),this.emit("frame")}connected(e,t=""){e===this.connection&&t===this.refusal||(this.connection=e,this.refusal=t,this.emit("connection"))}};var HC=new URLSearchParams(location.search),Gp=Number(HC.get("user")),WC=new URLSearchParams(location.hash.slice(1)).get("token")||null,la=new ku(Number.isInteger(Gp)&&Gp>=1?Gp-1:null),Hp=()=>dm(la.settings.theme);Hp();la.on("settings",Hp);eo(Hp);var Wp=new Uu,Bu=new Ll(la,WC,`${location.protocol==="https:"?"wss":"ws"}://${location.host}/ws`);Bu.onPoint=(i,e)=>Wp.pointed(i,e);var zx=Z0(document.getElementById("app"),la,Bu),Vx=Fx(zx.stageElement,la,Bu,Wp);zx.attach(Vx);window.cotouch={store:la,connection:Bu,stage:Vx,stats:Wp};
