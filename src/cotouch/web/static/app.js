/*! cotouch page; sources cdd02c1f1ee1d1cd4e42e619869988713f055188dbe8f4778707f85b4b626842; licences of what it contains: licences.txt */
var hu=["#0072B2","#D55E00","#009E73","#CC79A7","#E69F00","#56B4E9","#8B6F47","#6B7280"],_y=["#3D9FE0","#F08438","#2BC495","#DE97BF","#F2B73C","#86CCF5","#B3946A","#9CA3AF"];var by=["#414487","#355F8D","#2A788E","#21908D","#22A884","#43BF71","#7AD151","#BBDF27","#FDE725"],nl=by,tl=typeof matchMedia=="function"?matchMedia("(prefers-color-scheme: dark)"):null;function Us(i){return i==="dark"||i==="auto"&&tl!==null&&tl.matches}function zr(i){return tl?.addEventListener("change",i),()=>tl?.removeEventListener("change",i)}function xi(i,e){return(e?_y:hu)[i%hu.length]}function up(i,e=document.documentElement){let t=Us(i);e.dataset.theme=t?"dark":"light",e.style.colorScheme=t?"dark":"light";for(let n=0;n<hu.length;n++)e.style.setProperty(`--user-${n}`,xi(n,t))}function Fs(i){let e=parseInt(i.slice(1),16);return[e>>16,e>>8&255,e&255]}function Os(i,e){return`rgb(${Fs(i).join(" ")} / ${e})`}var My=["script","free","hold","pull","wander","grab","ball"],Sy=["ball","grab","free"];function na(i){let e=atob(i),t=new Uint8Array(e.length);for(let n=0;n<e.length;n++)t[n]=e.charCodeAt(n);return t.buffer}function dp(i){let e=new Float32Array(na(i.nodes.rest)),t=i.skin&&{vertices:i.skin.vertices,rest:new Float32Array(na(i.skin.rest)),triangles:new Uint32Array(na(i.skin.triangles)),node:new Uint32Array(na(i.skin.node))};return{...i,nodes:{count:i.nodes.count,rest:e},skin:t,edges:i.edges?new Uint32Array(na(i.edges)):null,started:String(i.started),points:t?t.rest:e}}function uu(i,e){return[i.getFloat32(e,!0),i.getFloat32(e+4,!0),i.getFloat32(e+8,!0)]}function fp(i,e){let t=new DataView(i);if(i.byteLength<32||t.getUint8(0)!==1||t.getUint8(1)!==1)throw new RangeError("not a frame of version 1");let n=t.getUint16(2,!0),s=t.getUint32(16,!0),r=68+4*Math.ceil(s*6/4);if(i.byteLength!==32+n*r)throw new RangeError("a frame of the wrong length");let o=[];for(let a=0;a<n;a++){let l=32+a*r,c=t.getUint8(l+2);o.push({seat:t.getUint8(l),mode:My[t.getUint8(l+1)]??"free",direct:(c&1)>0,hasHand:(c&2)>0,hands:t.getUint8(l+3),age:t.getFloat32(l+4,!0),target:uu(t,l+8),place:uu(t,l+20),force:uu(t,l+32),radius:t.getFloat32(l+44,!0),energy:t.getFloat32(l+48,!0),supplied:t.getFloat32(l+52,!0),lost:t.getFloat32(l+56,!0),linked:t.getFloat32(l+60,!0),node:t.getInt32(l+64,!0),displacement:new Int16Array(i,l+68,s*3)})}return{number:t.getUint32(4,!0),time:t.getFloat64(8,!0),points:s,scale:t.getFloat32(20,!0),echo:t.getUint32(24,!0),served:t.getUint32(28,!0)/1e6,copies:o,received:e}}function pp(i){let e=new DataView(new ArrayBuffer(40));return e.setUint8(0,2),e.setUint8(1,i.seat),e.setUint8(2,Sy.indexOf(i.action)),e.setUint32(4,i.number,!0),e.setUint32(8,i.point,!0),i.target.forEach((t,n)=>e.setFloat32(12+4*n,t,!0)),e.setFloat32(24,i.radius,!0),e.setFloat32(28,i.stiffness,!0),e.setFloat64(32,i.time,!0),e.buffer}function mp(i,e,t){let n=new DataView(new ArrayBuffer(16));return n.setUint8(0,3),n.setUint32(4,i,!0),n.setFloat32(8,e,!0),n.setFloat32(12,t,!0),n.buffer}function gp(i,e,t){return JSON.stringify({type:"hello",version:1,token:i,seat:e,want:"all",rate:t})}var il=class{gaps=[];last=0;every=0;lead=4;get ahead(){return this.lead}picture(e){let t=e-this.last;t<=0||(this.last=e,!(t>60)&&(this.gaps.push(t),this.gaps.length>24&&this.gaps.shift(),this.gaps.length===24&&(this.every=[...this.gaps].sort((n,s)=>n-s)[6])))}came(e){if(!this.every||e-this.last>240)return[0,0];let t=this.until(e);return t<.5||t>this.lead+Math.min(3.5,.35*this.every)?this.lead+=.6:this.lead-=.04,this.lead>this.every+.5&&(this.lead-=this.every),this.lead<.5&&(this.lead=.5),[this.until(e+this.lead),this.every]}until(e){let t=(e-this.last)%this.every;return t<0?-t:this.every-t}};var du=250,vp=2e3,wy=1e4,Ey=8,Ty=60,Ay=300,Cy=5;function Ry(i,e){return i.action===e.action&&i.point===e.point&&i.radius===e.radius&&i.stiffness===e.stiffness&&i.target.every((t,n)=>t===e.target[n])}var sl=class{constructor(e,t,n){this.store=e;this.token=t;this.address=n;e.on("seat",()=>this.hello()),document.addEventListener("visibilitychange",()=>this.hello()),addEventListener("online",()=>this.hurry()),this.dial()}store;token;address;onPoint=null;screen=new il;socket=null;wait=du;timer=0;asked=0;answers=new Map;number=0;pending=null;state=null;told=null;pointed=-1/0;pointTimer=0;closed=!1;said=null;get mayAct(){let{connection:e,state:t,scene:n,seat:s}=this.store;return e==="open"&&this.hasToken&&t?.control!=="other"&&!!n?.own.includes(s)}get hasToken(){return this.token!==null&&this.store.scene?.acts!==!1}get tokenWrong(){return this.token!==null&&!this.hasToken}link(e){return`${e}?token=${encodeURIComponent(this.token??"")}`}do(e,t={}){let n=this.socket;if(!n||n.readyState!==WebSocket.OPEN)return Promise.resolve({ok:!1,text:"There is no connection to the server."});let s=++this.asked;return new Promise(r=>{let o=setTimeout(()=>this.answer(s,{ok:!1,text:"The server did not answer."}),wy);this.answers.set(s,a=>{clearTimeout(o),r(a)}),n.send(JSON.stringify({...t,type:"do",id:s,what:e}))})}point(e){if(this.told&&Ry(this.told,e))return;this.pending?.action==="free"&&e.action!=="free"&&this.flush(),this.told=e,this.pending={...e,time:e.time??performance.now()};let t=this.pointed+Ey-performance.now();t<=0||e.action==="free"?this.flush():this.pointTimer||(this.pointTimer=setTimeout(()=>this.flush(),t))}close(){this.closed=!0,clearTimeout(this.timer),clearTimeout(this.pointTimer),this.socket?.close()}flush(){clearTimeout(this.pointTimer),this.pointTimer=0;let e=this.pending;if(this.pending=null,!e||!this.mayAct||this.socket?.readyState!==WebSocket.OPEN)return;this.pointed=performance.now();let t=++this.number,n=e.time;this.socket.send(pp({...e,seat:this.store.seat,number:t,time:n})),this.onPoint?.(t,n)}dial(){if(clearTimeout(this.timer),this.closed)return;let e=new WebSocket(this.address);e.binaryType="arraybuffer",this.socket=e;let t="";e.onopen=()=>{this.told=null,this.hello()},e.onmessage=({data:n})=>{if(n instanceof ArrayBuffer){let r=fp(n,performance.now());e.send(mp(r.number,...this.screen.came(r.received))),requestAnimationFrame(o=>this.screen.picture(o)),this.store.scene&&r.points*3===this.store.scene.points.length&&this.store.drawn(r);return}let s=JSON.parse(n);s.type==="scene"?(this.wait=du,this.store.connected("open"),this.state=null,this.store.show(dp(s)),this.said!==this.store.seat&&this.hello()):s.type==="state"?this.tell(s):s.type==="told"?this.answer(s.id,s):s.type==="error"&&(t=String(s.text))},e.onclose=()=>{if(this.socket===e){this.socket=null;for(let n of[...this.answers.keys()])this.answer(n,{ok:!1,text:"The connection was lost before an answer came."});t?this.store.connected("refused",t):this.store.connection!=="refused"&&this.store.connected(this.store.scene?"lost":"connecting"),!this.closed&&(this.timer=setTimeout(()=>this.dial(),t?vp:this.wait),this.wait=Math.min(2*this.wait,vp))}}}tell(e){let t=this.state!==null;if(this.state=e,t)return;let n=()=>{clearTimeout(s);let r=this.state;this.state=null,r&&this.store.told(r)},s=setTimeout(n,Ay);this.store.state?requestAnimationFrame(()=>setTimeout(n)):n()}hello(){this.socket?.readyState===WebSocket.OPEN&&(this.said=this.store.scene||this.store.wished!==null?this.store.seat:null,this.socket.send(gp(this.token,this.said,document.hidden?Cy:Ty)))}hurry(){this.socket||(this.wait=du,this.dial())}answer(e,t){this.answers.get(e)?.(t),this.answers.delete(e)}};var ar=class{constructor(e){this.current=e}current;listeners=new Set;get(){return this.current}set(e){if(!Object.is(e,this.current)){this.current=e;for(let t of[...this.listeners])t(e)}}on(e){return this.listeners.add(e),()=>this.listeners.delete(e)}},yp=["users","network","plots","energy","margin","events"];function Ut(i,e){return i.scene?.users.find(t=>t.seat===e)?.name??`user ${e+1}`}function Zi(i,e){return i<e?[i,e]:[e,i]}function Yn(i){return`${i[0]}-${i[1]}`}function Ki(i,e){return i===e||i!==null&&e!==null&&i[0]===e[0]&&i[1]===e[1]}function At(i,e){let{store:t,connection:n}=i;return t.connection==="open"&&n.hasToken&&!t.state?.ended&&!!t.scene?.may.includes(e)}function xp(i,e,t){let{scene:n,frame:s}=i.store;if(!n)return null;let r=s?.copies.find(c=>c.seat===e),o=n.nodes.rest,a=r&&r.node>=0&&r.node<n.nodes.count?r.node:-1;if(a<0){let c=-1/0;for(let h=0;h<n.nodes.count;h++){let u=o[3*h]*t[0]+o[3*h+1]*t[1]+o[3*h+2]*t[2];u>c+1e-9&&([c,a]=[u,h])}}if(a<0)return null;let l=n.dimension===1?Math.max(n.radius,.1):.35*n.radius;return{node:a,to:[0,1,2].map(c=>o[3*a+c]+l*t[c])}}var Py="http://www.w3.org/2000/svg";function _p(i,e,t){for(let[n,s]of Object.entries(e??{}))s==null||s===!1||(n.startsWith("on")&&typeof s=="function"?i.addEventListener(n.slice(2),s):i.setAttribute(n,s===!0?"":String(s)));for(let n of t)n&&i.append(n)}function F(i,e=null,...t){let n=document.createElement(i);return _p(n,e,t),n}function Jt(i,e=null,...t){let n=document.createElementNS(Py,i);return _p(n,e,t),n}function Fe(i,e){i.textContent!==e&&(i.textContent=e)}function We(i,e,t){t===null?i.removeAttribute(e):i.getAttribute(e)!==t&&i.setAttribute(e,t)}function St(i,e){i.hidden===e&&(i.hidden=!e)}var bp={good:"M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8M5.2 8.2l2 2 3.7-4.2",warn:"M8 2 1.8 13.2h12.4zM8 6.4v3.2M8 11.3v.3",bad:"M5.4 1.8h5.2l3.6 3.6v5.2l-3.6 3.6H5.4l-3.6-3.6V5.4zM5.8 5.8l4.4 4.4M10.2 5.8l-4.4 4.4",wait:"M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8M8 4.6V8l2.4 1.6",close:"m4 4 8 8M12 4l-8 8",cut:"M5.6 10.6 12.6 3M10.4 10.6 3.4 3M4.2 10.4a1.7 1.7 0 1 0 0 3.4 1.7 1.7 0 0 0 0-3.4M11.8 10.4a1.7 1.7 0 1 0 0 3.4 1.7 1.7 0 0 0 0-3.4",mend:"M6.6 9.4a2.6 2.6 0 0 0 3.8.2l2-2a2.6 2.6 0 0 0-3.7-3.7l-1 1M9.4 6.6a2.6 2.6 0 0 0-3.8-.2l-2 2a2.6 2.6 0 0 0 3.7 3.7l1-1",invite:"M6.4 2.4a2.6 2.6 0 1 0 0 5.2 2.6 2.6 0 0 0 0-5.2M1.8 13.6c.3-2.6 2-4 4.6-4s4.3 1.4 4.6 4M12.4 5v4M10.4 7h4",tour:"M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8m2.8 3.4L9.2 9.2l-4 1.6 1.6-4z",light:"M8 5.2a2.8 2.8 0 1 0 0 5.6 2.8 2.8 0 0 0 0-5.6M8 1.4v1.4M8 13.2v1.4M1.4 8h1.4M13.2 8h1.4M3.3 3.3l1 1M11.7 11.7l1 1M12.7 3.3l-1 1M4.3 11.7l-1 1",dark:"M13.4 9.6A5.8 5.8 0 0 1 6.4 2.6a5.8 5.8 0 1 0 7 7z",auto:"M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8v12.4M8 5h3.6M8 8h5.6M8 11h3.6",record:"M8 4.6a3.4 3.4 0 1 0 0 6.8 3.4 3.4 0 0 0 0-6.8",stop:"M4.8 4.8h6.4v6.4H4.8z",save:"M8 2.4v7M5 6.8l3 3 3-3M2.8 13.2h10.4",pause:"M5.6 3.6v8.8M10.4 3.6v8.8",play:"m5.2 3.4 7 4.6-7 4.6z",keys:"M1.8 4.4h12.4v7.4H1.8zM4.4 7h.2M7 7h.2M9.6 7h.2M12 7h.2M5 9.4h6",reset:"M3 8a5 5 0 1 0 1.6-3.7M3 2.6v2.6h2.6",grab:"M5 8.4V4.6a1 1 0 0 1 2 0V7.4 3.4a1 1 0 0 1 2 0v4-3a1 1 0 0 1 2 0v3.4-1.6a1 1 0 0 1 2 0v3.4c0 3-1.6 4.6-4.2 4.6-2 0-2.8-.8-4-2.6L2.6 8.8c.6-.8 1.6-.8 2.4-.4",ball:"M6.2 6.2a3.6 3.6 0 1 0 0-.1M1.6 13.4c3.4 0 3.4-3.4 6.2-3.4s3 3.4 6.6 3.4",ghosts:"M8 2.2c-2.6 0-4.2 2-4.2 4.4v6.6l1.6-1.2 1.4 1.2L8 12l1.2 1.2 1.4-1.2 1.6 1.2V6.6c0-2.4-1.6-4.4-4.2-4.4M6.4 6.4v.4M9.6 6.4v.4",side:"M2 3.4h5v9.2H2zM9 3.4h5v9.2H9z",overlay:"M2.4 2.4h7.8v7.8H2.4zM5.8 5.8h7.8v7.8H5.8z",minus:"M3.4 8h9.2",tick:"m3.4 8.4 3 3 6.2-6.8"};function an(i,e=16){return Jt("svg",{viewBox:"0 0 16 16",width:e,height:e,class:`icon icon-${i}`,"aria-hidden":"true"},Jt("path",{d:bp[i]}))}function Cn(i,e){We(i,"class",`icon icon-${e}`);let t=i.firstElementChild;t&&We(t,"d",bp[e])}function Ye(i,e,t={}){return F("button",{type:"button",class:t.class??"button",id:t.id,"aria-label":t.label,"data-tip":t.tip,onclick:e},t.icon&&an(t.icon),i&&F("span",null,i))}function lr(i,e,t){let n=new Map,s=F("div",{class:"choice",role:"radiogroup","aria-label":i});for(let o of e){let a=Ye(o.words,()=>t(o.value),{class:"choice-one",...o.icon?{icon:o.icon}:{},...o.tip?{tip:o.tip}:{}});a.setAttribute("role","radio"),a.setAttribute("aria-checked","false"),a.dataset.value=o.value,n.set(o.value,a),s.append(a)}s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowDown:1,ArrowLeft:-1,ArrowUp:-1}[o.key];if(!a)return;let l=[...n.values()].filter(h=>!h.disabled),c=l.indexOf(document.activeElement);l[(c+a+l.length)%l.length]?.focus(),o.preventDefault(),o.stopPropagation()});let r=()=>{let o=[...n.values()],a=o.find(l=>l.getAttribute("aria-checked")==="true")??o[0];for(let l of o)We(l,"tabindex",l===a?"0":"-1")};return r(),{element:s,mark(o){for(let[a,l]of n)We(l,"aria-checked",String(a===o));r()},allow(o,a){let l=n.get(o);l&&(l.disabled=!a)},say(o,a,l){let c=n.get(o);c&&(c.lastElementChild&&Fe(c.lastElementChild,a),We(c,"data-tip",l))}}}var Iy=0;function _i(i,e,t,...n){let s=`explained-${++Iy}`,r=F("div",{class:"explanation",id:s,hidden:!0},t),o=F("button",{type:"button",class:"ask","aria-expanded":"false","aria-controls":s,"aria-label":`What ${e} shows`},"?");o.addEventListener("click",()=>{r.hidden=!r.hidden,o.setAttribute("aria-expanded",String(!r.hidden))});let a=F("div",{class:"panel-head"},F("h2",{id:`${i}-title`},e),o,F("div",{class:"grow"}),...n),l=F("div",{class:"panel-body"});return{element:F("section",{id:i,class:"panel","aria-labelledby":`${i}-title`},a,r,l),body:l,head:a}}function ji(i,e){let t=Math.abs(i).toFixed(e);return i<0&&Number(t)!==0?"−"+t:t}function Qi(i,e=0){return i==null||!Number.isFinite(i)?"–":ji(i,e)}var Ly=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"],[1e-12,"p"]];function Vr(i,e,t=0){if(i==null||!Number.isFinite(i))return"–";let n=Math.abs(i);if(n<=t||n<1e-15)return`0 ${e}`;let[s,r]=Ly.find(([l])=>n>=l*.9995)??[1e-12,"p"],o=i/s,a=Math.abs(o)>=99.95?0:Math.abs(o)>=9.995?1:2;return`${ji(o,a)} ${r}${e}`}function rl(i){return i==null||!Number.isFinite(i)?"–":Math.abs(i)<10?`${ji(i,2)} N`:`${ji(i,1)} N`}function kn(i){if(i==null||!Number.isFinite(i))return"–";let e=Math.abs(i);return e>=.9995?`${ji(i,2)} s`:`${ji(i*1e3,e<.00995?1:0)} ms`}function Rn(i,e){if(i==null||!Number.isFinite(i))return"–";let t=i*100,n=Math.abs(t);return`${ji(t,e??(n===0||n>=9.95?0:1))} %`}function Mp(i){return i==null||!Number.isFinite(i)?"–":Math.abs(i)<.1?`${ji(i*1e3,1)} mm`:`${ji(i*100,1)} cm`}function ol(i){return i==null?"–":`${ji(i,0)} Hz`}function al(i){let e=Math.max(0,Math.floor(i));return`${Math.floor(e/60)}:${String(e%60).padStart(2,"0")}`}function ia(i){return String(Math.round(i)).replace(/\B(?=(\d{3})+$)/g," ")}function es(i,e){return`${Math.min(i,e)+1}–${Math.max(i,e)+1}`}function cr(i,e,t,...n){let s=F("span",null),r=F("div",{class:`banner banner-${i}`,id:e,role:i==="bad"?"alert":"status",hidden:!0},an(i==="info"?"wait":i,16),s,...n);return{element:r,update:()=>{let o=t();St(r,o!==null),o!==null&&Fe(s,o)}}}function Sp(i){let{store:e,connection:t}=i,n=Ye("Restore now",()=>{i.act("damping",{share:1})},{class:"button small primary"}),s=Ye("Take over",()=>{i.act("control")},{class:"button small primary"}),r=Ye("Cancel",()=>i.aiming.set(null),{class:"button small"}),o=[cr("bad","banner-lost",()=>e.connection==="lost"?"The connection is lost; what you see is the last that was known. Connecting again …":null),cr("bad","banner-refused",()=>e.connection==="refused"?`The server refused this page: ${e.refusal||"no reason was given."}`:null),cr("info","banner-ended",()=>e.connection!=="refused"&&e.state?.ended?"The session has ended. What you see is its last moment.":null),cr("bad","banner-damping",()=>{let l=e.state?.damping??1;return n.disabled=!At(i,"damping"),e.connection==="open"&&l<1?`Damping is lowered to ${Rn(l,l<.01?1:0)} of what is needed: the session is not passive.`:null},n),cr("info","banner-view",()=>e.connection==="open"&&e.scene&&!t.hasToken?t.tokenWrong?"You are watching: the token in this address is not that of the session that runs now. Open the address that cotouch printed last.":"You are watching. To take part, open the address with the token that cotouch printed.":null),cr("warn","banner-control",()=>e.connection==="open"&&t.hasToken&&!e.state?.ended&&e.state?.control==="other"?`Another page holds the control of ${Ut(e,e.seat)}.`:null,s),cr("info","banner-aim",()=>{let l=i.aiming.get();return l?`Click in the picture where ${Ut(e,l.seat)} shall pull.`:null},r)],a=()=>{for(let l of o)l.update();document.documentElement.toggleAttribute("data-lost",e.connection==="lost"||e.connection==="refused")};for(let l of["scene","state","connection","seat"])e.on(l,a);return i.aiming.on(a),a(),F("div",{class:"banners"},...o.map(l=>l.element))}var Ny={auto:"light",light:"dark",dark:"auto"},wp={auto:"as the system",light:"light",dark:"dark"};function fu(i){i.set({theme:Ny[i.settings.theme]})}function Ep(i){let e=Ye("",()=>fu(i),{icon:"auto",class:"button bare",label:"Theme",id:"theme"}),t=()=>{let{theme:n}=i.settings,s=e.querySelector("svg");s&&Cn(s,n),e.setAttribute("aria-label",`Theme: ${wp[n]}`),e.setAttribute("data-tip",`Theme: ${wp[n]} (D)`)};return i.on("settings",t),t(),e}var Dy={good:"good",warn:"take note",bad:"not guaranteed"};function Uy(){return Jt("svg",{viewBox:"0 0 24 24",width:24,height:24,class:"mark","aria-hidden":"true"},Jt("circle",{cx:8,cy:9,r:5.4,class:"mark-a"}),Jt("circle",{cx:16,cy:9,r:5.4,class:"mark-b"}),Jt("circle",{cx:12,cy:15.6,r:5.4,class:"mark-c"}))}function Fy(i){let{store:e,connection:t}=i,n=()=>{At(i,"record")&&i.act("record",{on:e.state?.recording==null})},s=F("span",{class:"tabular"},"Record"),r=F("button",{type:"button",class:"button",id:"record","data-tip":"Record what every copy does, to audit or replay it (R)"},an("record"),s);r.addEventListener("click",n);let o=F("a",{class:"button",download:"recording.zip",hidden:!0,id:"download","data-tip":"The last recording, as a ZIP of MCAP files"},an("save"),F("span",{class:"label"},"Download")),a=()=>{let l=e.state?.recording??null,c=l!==null;We(r,"data-on",c?"":null),We(r,"aria-pressed",String(c)),We(r,"aria-label",c?"Stop recording":"Record");let h=r.querySelector("svg");h&&Cn(h,c?"stop":"record"),Fe(s,c?al(l):"Record"),r.disabled=!At(i,"record"),St(r,!!e.scene?.may.includes("record"));let u=!!e.state?.recorded&&!c&&t.hasToken;St(o,u),u&&We(o,"href",t.link("recording.zip"))};for(let l of["scene","state","connection"])e.on(l,a);return a(),{element:F("div",{class:"recorder"},r,o),toggle:n}}function Tp(i,e){let{store:t}=i,n=F("span",{class:"session"}),s=an("wait",18),r=F("span",{class:"unseen"}),o=F("span",{class:"verdict-words"},"Connecting …"),a=F("button",{type:"button",class:"verdict",id:"verdict"},s,r,o);a.addEventListener("click",()=>i.tab.set("margin"));let l=Ye("Invite",e.invite,{icon:"invite",class:"button",id:"invite",tip:"Let somebody take part from another computer (I)"}),c=Fy(i),h=F("header",{class:"bar"},F("h1",{class:"brand"},Uy(),F("span",null,"cotouch"),n),a,F("div",{class:"bar-tools"},c.element,l,Ye("Tour",e.tour,{icon:"tour",class:"button",id:"tour-open",tip:"Two minutes through everything (T)"}),Ye("",e.keys,{icon:"keys",class:"button bare",label:"Keyboard shortcuts",tip:"Keyboard shortcuts (?)"}),Ep(t))),u=()=>{Fe(n,t.scene?.title??""),We(n,"title",t.scene?`${t.scene.title} · cotouch ${t.scene.version}`:null);let d=t.connection==="open"?t.state?.verdict:void 0;We(a,"data-level",d?.level??"none"),Cn(s,d?.level??"wait"),Fe(r,d?`${Dy[d.level]}: `:"");let f=d?.text??(t.connection==="open"?"Waiting for the copies …":t.connection==="lost"?"Connection lost":"Connecting …"),g=f&&f[0]?.toUpperCase()+f.slice(1);Fe(o,g),We(a,"data-tip",`${g}. Opens the margin of every link.`);let v=[t.scene?.title,"cotouch"].filter(Boolean).join(" · ");document.title!==v&&(document.title=v),l.hidden=!t.scene?.invitation};for(let d of["scene","state","connection"])t.on(d,u);return u(),{element:h,record:c.toggle}}var Oy="Every step books where its energy went, to rounding, so both bars are equally long: what came in is what is still there or was damped. Hands put energy in, and take some back. Links are springs between copies: they give back what they hold, and delay makes them give more than they took, because news that is late pushes at the wrong moment. The damping is made to take at least that; this is what keeps the session stable. As members come and go each copy holds another share of the object, and of its energy. What is left over after all this is rounding.";function ky(i,e,t){let n=o=>(e[o]??0)-(t?.[o]??0),s=t?t.energy??0:e.initial??0,r={seat:i,initial:s,hands:n("supplied"),links:n("linked"),shared:n("rescaled"),damped:n("lost"),stored:e.energy??0};return{...r,residual:r.initial+r.hands+r.links+r.shared-r.damped-r.stored}}function By(i){let e=[],t=[],n=(s,r,o)=>{s>0?e.push({...r,value:s}):s<0&&t.push({...o,value:-s})};for(let s of i)n(s.hands,{label:"hand",class:"hand",seat:s.seat},{label:"taken back by hand",class:"hand",seat:s.seat});return n(i.reduce((s,r)=>s+r.initial,0),{label:"at the start",class:"initial"},{label:"at the start",class:"initial"}),n(i.reduce((s,r)=>s+r.links,0),{label:"added by links",class:"links"},{label:"held or taken by links",class:"links"}),n(i.reduce((s,r)=>s+r.shared,0),{label:"members went",class:"shared"},{label:"members came",class:"shared"}),n(-i.reduce((s,r)=>s+r.damped,0),{label:"dampers",class:"damped"},{label:"damped",class:"damped"}),n(-i.reduce((s,r)=>s+r.stored,0),{label:"copies",class:"stored"},{label:"in the copies",class:"stored"}),{came:e,went:t}}var Gr=[{key:"hands",words:"hands",sign:"",tip:"Put in by this user’s hand, less what it took back"},{key:"links",words:"links",sign:"+",tip:"Work of the links on this copy: what delays added, less what springs hold"},{key:"initial",words:"start",sign:"+",tip:"In the copy when counting began"},{key:"shared",words:"shares",sign:"+",tip:"What this copy gained or lost as members came and went: each then holds another share of the object"},{key:"damped",words:"damped",sign:"−",tip:"Lost in this copy’s dampers"},{key:"stored",words:"in copy",sign:"−",tip:"In this copy now, as motion and in springs"},{key:"residual",words:"rest",sign:"=",tip:"Rounding"}],pu=[[1e3,"kJ"],[1,"J"],[.001,"mJ"],[1e-6,"µJ"],[1e-9,"nJ"]];function Ap(i,e){let t=Math.abs(i)/e;return Math.abs(i)<1e-12?"0":Qi(i/e,t>=99.95?0:t>=9.995?1:2)}function Cp(i,e,t,n){for(;i.children.length>e.length;)i.lastElementChild?.remove();for(;i.children.length<e.length;)i.append(F("div",null,F("span")));e.forEach((s,r)=>{let o=i.children[r],a=t>0?s.value/t:0,l=s.seat===void 0?s.label:`${s.label} of ${n(s.seat)}`;We(o,"class",`part part-${s.class}`),o.style.width=`${(100*a).toFixed(2)}%`,s.seat!==void 0&&(o.style.setProperty("--user",`var(--user-${s.seat})`),o.style.setProperty("--on-user",`var(--on-user-${s.seat})`)),We(o,"data-tip",`${l}: ${Vr(s.value,"J",1e-12)}`);let c=s.seat===void 0?s.label:String(s.seat+1);o.firstElementChild&&Fe(o.firstElementChild,a>(s.seat===void 0?.18:.06)?c:"")})}function Pp(i){let{store:e}=i,t=new Map,n=Ye("Count from now",()=>{if(t.size)t.clear();else for(let[C,E]of Object.entries(e.state?.members??{}))t.set(Number(C),{...E});M()},{class:"button small",tip:"Leaves out what was before"}),{element:s,body:r}=_i("energy","Energy",Oy,n),[o,a]=[F("div",{class:"stack"}),F("div",{class:"stack"})],[l,c]=[F("span",{class:"sum tabular"}),F("span",{class:"sum tabular"})],h=F("th",{scope:"col"}),u=F("tr",null,h,...Gr.map(C=>F("th",{scope:"col","data-tip":C.tip,tabindex:0},`${C.sign} ${C.words}`.trim()))),d=F("tbody"),f=Gr.map(()=>F("td")),g=F("p",{class:"expected tabular"}),v=F("p",{class:"hint"},"Nothing was booked yet."),m=F("table",{class:"numbers ledger"},F("thead",null,u),d,F("tfoot",null,F("tr",null,F("th",{scope:"row"},"all"),...f))),p=F("div",{hidden:!0},F("div",{class:"bar-row"},F("span",{class:"bar-name"},"came in"),o,l),F("div",{class:"bar-row"},F("span",{class:"bar-name"},"went to"),a,c),g,F("div",{class:"scroll"},m));r.append(v,p);let x=new Map,M=()=>{if(r.offsetParent===null&&x.size)return;let C=Object.entries(e.state?.members??{}).filter(([,k])=>k.steps).map(([k,re])=>{let q=Number(k),j=t.get(q)??null;return j&&(re.steps??0)<(j.steps??0)&&t.delete(q),ky(q,re,t.get(q)??null)});St(p,C.length>0),St(v,C.length===0),Fe(n.firstElementChild??n,t.size?"Count from the start":"Count from now");let E=By(C),y=k=>k.reduce((re,q)=>re+q.value,0),[S,U]=[y(E.came),y(E.went)],L=Math.max(S,U),R=k=>Ut(e,k);Cp(o,E.came,L,R),Cp(a,E.went,L,R),Fe(l,Vr(S,"J",1e-12)),Fe(c,Vr(U,"J",1e-12));let O=S-U,V=Math.max(0,...Object.values(e.state?.members??{}).map(k=>k.residual??0));We(g,"data-left",L>0?String(Math.abs(O)/L):null),Fe(g,L>0?`Left over: ${Rp(O/L)} of what came in. Worst single step: off by ${Rp(V)} of the energy in play.`:"");let P=Math.max(1e-9,...C.flatMap(k=>Gr.map(re=>Math.abs(k[re.key])))),[H,Y]=pu.find(([k])=>P>=k)??pu[pu.length-1];Fe(h,Y);for(let[k,re]of x)C.some(q=>q.seat===k)||(re.element.remove(),x.delete(k));for(let k of C){let re=x.get(k.seat);if(!re){let q=Gr.map(()=>F("td")),j=F("tr",null,F("th",{scope:"row",title:R(k.seat)},F("span",{class:"badge tiny",style:`--user:var(--user-${k.seat});--on-user:var(--on-user-${k.seat})`},String(k.seat+1))),...q);re={element:j,cells:q},x.set(k.seat,re),d.append(j);for(let te of[...x.keys()].sort((de,ue)=>de-ue))d.append(x.get(te)?.element??j)}Gr.forEach((q,j)=>{let te=re.cells[j];te&&Fe(te,Ap(k[q.key],H))})}We(m,"data-initial",C.some(k=>k.initial)?"":null),Gr.forEach((k,re)=>{let q=f[re];q&&Fe(q,Ap(C.reduce((j,te)=>j+te[k.key],0),H))})};e.on("state",M);let b=e.scene?.started;return e.on("scene",()=>{e.scene?.started!==b&&t.clear(),b=e.scene?.started,M()}),i.tab.on(M),M(),s}var zy={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};function Rp(i){if(!Number.isFinite(i))return"–";let e=Math.abs(i);if(e===0)return"0";if(e>=.01)return Rn(e);let t=Math.floor(Math.log10(e));return`${Math.round(e/10**t)} · 10${[...String(t)].map(n=>zy[n]??"").join("")}`}var Vy=200;function Ip(i){let{store:e}=i,{element:t,body:n}=_i("events","Events","What happened in the session: who came and went, links that were guarded, what was asked for. Newest first."),s=F("ol",{class:"events tabular"}),r=F("p",{class:"hint"},"Nothing happened yet.");n.append(r,s);let o=-1/0,a=new Set,l="",c=()=>{let h=e.scene?.started??"";h!==l&&(l=h,[o,a]=[-1/0,new Set],s.replaceChildren());for(let u of e.state?.events??[]){let d=`${u.time} ${u.text}`;u.time<o||a.has(d)||(u.time>o&&a.clear(),o=u.time,a.add(d),s.prepend(F("li",null,F("time",null,al(u.time)),F("span",null,u.text))))}for(;s.children.length>Vy;)s.lastElementChild?.remove();St(r,!s.children.length)};return e.on("state",c),c(),t}var Gy=0;function Hr(i,e,t){let n=`dialog-${++Gy}`,s=F("dialog",{class:"dialog","aria-labelledby":n}),r=()=>s.close();return s.append(F("div",{class:"panel-head"},F("h2",{id:n},i),F("div",{class:"grow"}),Ye("",r,{icon:"close",class:"button bare",label:"Close"})),F("div",{class:"dialog-body"},...e),F("div",{class:"dialog-actions"},...t.map(o=>{let a=Ye(o.words,()=>{r(),o.act()},{class:o.class});return o.focus&&(a.autofocus=!0),a}))),s.addEventListener("click",o=>{o.target===s&&r()}),document.body.append(s),{element:s,close:r,open:()=>{s.open||s.showModal()}}}var mu={here:{words:"here",icon:"good"},starting:{words:"starting",icon:"wait"},gone:{words:"gone",icon:"bad"},stopped:{words:"stopped",icon:"bad"},awaited:{words:"not here yet",icon:"wait"}};function ks(i,e){let t=i?.members[e];return t?t.alive===!1?"stopped":t.here?t.steps?"here":"starting":t.alive?"starting":t.steps?"gone":"awaited":"awaited"}var oi={coupled:{words:"coupled",means:"Both ends feel each other through the spring.",icon:"good"},catching:{words:"catching up",means:"The end has caught up and shows that it can be relied on; it couples when both have.",icon:"wait"},guarded:{words:"guarded",means:"News is older than its budget, or was. The end moves its spring only as far as its saved energy pays for.",icon:"warn"},waiting:{words:"waiting",means:"Nothing was heard yet.",icon:"wait"},cut:{words:"cut",means:"Nothing gets through. Each end lets go of its spring without a kick.",icon:"bad"},off:{words:"not linked",means:"These two are not joined directly.",icon:"minus"}},Hy={coupled:"coupled",ready:"catching",guarded:"guarded",waiting:"waiting",keys:"waiting"};function ll(i){return i?Hy[i.state]??"waiting":"waiting"}var Wy=["cut","guarded","waiting","catching","coupled"];function Wr(i,e,t){if(!i)return"waiting";if(hr(i,e,t))return"cut";if(!i.links.some(([s,r])=>s===e&&r===t||s===t&&r===e))return"off";let n=[ll(i.ends[`${e}-${t}`]),ll(i.ends[`${t}-${e}`])];return Wy.find(s=>n.includes(s))??"waiting"}function hr(i,e,t){return!!(i.emulated[`${e}-${t}`]?.cut||i.emulated[`${t}-${e}`]?.cut)}function Ri(i,e,t,n){let s=[i?.ends[`${e}-${t}`]?.[n],i?.ends[`${t}-${e}`]?.[n]].filter(r=>typeof r=="number");return s.length?Math.max(...s):null}function cl(i,e,t){let[n,s]=[Ri(i,e,t,"ages"),Ri(i,e,t,"budget")];return n===null||s===null||s<=0?null:1-n/s}var Lp={script:"follows the script",free:"hand free",hold:"holds still",pull:"pulls",wander:"wanders",grab:"pointer grabs",ball:"pointer pushes",elsewhere:"on another computer"};async function Np(i,e,t){try{await navigator.clipboard.writeText(e),i.say(`${t} copied.`,"good")}catch{i.say("The browser does not let this page copy; mark the text and copy it yourself.","warn")}}function Xy(i){return/^[\w.-]+$/.test(i)?i:`'${i.replaceAll("'","'\\''")}'`}function Dp(i){let{store:e,connection:t}=i,n=F("textarea",{readonly:!0,rows:3,"aria-label":"Invitation",spellcheck:"false"}),s=F("textarea",{readonly:!0,rows:3,"aria-label":"Command",spellcheck:"false"}),r=F("select",{"aria-label":"Whose place"}),o=F("p",{class:"hint",role:"status"}),a=F("img",{alt:"The invitation as a QR code",width:168,height:168,class:"qr"}),l=Ye("Free this place",()=>{let d=Number(r.value);i.act("kill",{seat:d})},{class:"button small danger",icon:"stop"}),c=F("p",{class:"hint"},"Whoever has the invitation can take part: give it only to those you trust. The other computer must reach this one over the network."),h=Hr("Invite",[F("div",{class:"invite"},F("div",{class:"invite-words"},F("label",{class:"field"},F("span",null,"1. Whose place shall be taken?"),F("span",{class:"row"},r,l)),o,F("div",{class:"field"},F("span",null,"2. On the other computer, type"),s,F("span",{class:"row"},Ye("Copy the command",()=>{Np(i,s.value,"Command")},{class:"button small primary"}))),F("div",{class:"field"},F("span",null,"or hand over the invitation alone"),n,F("span",{class:"row"},Ye("Copy the invitation",()=>{Np(i,n.value,"Invitation")},{class:"button small"})))),F("figure",{class:"qr-frame"},a,F("figcaption",null,"or scan it"))),c],[]),u=()=>{if(!h.element.open)return;let d=e.scene?.invitation??"",f=Number(r.value);n.value!==d&&(n.value=d);let g=`cotouch join ${d} --name ${Xy(Ut(e,f))}`;s.value!==g&&(s.value=g);let v=ks(e.state,f),m=v==="here"||v==="starting";Fe(o,m?`${Ut(e,f)} is played by a process here. Free the place first; the object stays, and whoever joins with this name takes it.`:`The place of ${Ut(e,f)} is free.`),St(l,m),l.disabled=!At(i,"kill")||!e.scene?.own.includes(f)};return r.addEventListener("change",u),e.on("state",u),e.on("scene",u),{open:()=>{if(!e.scene?.invitation)return;let d=e.scene.users,f=r.value;r.replaceChildren(...d.map(v=>F("option",{value:v.seat},`${v.seat+1} · ${v.name}`)));let g=d.find(v=>!["here","starting"].includes(ks(e.state,v.seat)))??d.at(-1);r.value=f||String(g?.seat??0),a.src=t.link("qr.svg"),h.open(),u()}}}var qy="Every user moves a copy of the object in a process of its own, at its own rate. Late steps came more than half a period after they were due; the next step is then longer, and energy stays exact. Force is what the hand exerts on its copy. Unfold a user to tell its hand what to do, to stop its process, or to act as that user.",Up=[{value:"script",words:"Script",tip:"Move as the session’s file says"},{value:"hold",words:"Hold",tip:"Keep what is held where it is now"},{value:"free",words:"Let go",tip:"Hold nothing"},{value:"wander",words:"Wander",tip:"Draw it about slowly"},{value:"pull",words:"Pull …",tip:"Draw it to a place"}],$y=[{words:"−x",label:"back, −x",to:[-1,0,0],from:1},{words:"+x",label:"forward, +x",to:[1,0,0],from:1},{words:"−y",label:"right, −y",to:[0,-1,0],from:2},{words:"+y",label:"left, +y",to:[0,1,0],from:2},{words:"−z",label:"down, −z",to:[0,0,-1],from:3},{words:"+z",label:"up, +z",to:[0,0,1],from:3}];function gu(i,e){let t=F("dd",null,"–");return{element:F("div",{class:"metric","data-tip":e},F("dt",null,i),t),value:t}}function hl(i){let e=new URL(location.href);return e.searchParams.set("user",String(i+1)),e.href}function Yy(i,e){let{store:t}=i,n=!!t.scene?.own.includes(e),s=an("wait",14),r=F("span",{class:"presence-words"}),o=F("span",{class:"chip chip-mine",hidden:!0},"you"),a=F("span",{class:"hand-mode"}),l=gu("rate","Steps per second"),c=gu("late","Share of steps that came late, since the start"),h=gu("force","Of the hand on its copy"),u=`user-${e}-more`,d=F("button",{type:"button",class:"user-head","aria-expanded":"false","aria-controls":u},F("span",{class:"badge",style:`--user:var(--user-${e})`},String(e+1)),F("span",{class:"user-name",style:`--user:var(--user-${e})`},Ut(t,e)),o,F("span",{class:"grow"}),F("span",{class:"presence"},s,r));d.addEventListener("click",()=>i.opened.set(i.opened.get()===e?null:e));let f=F("div",{class:"pulls",hidden:!0}),g=(S,U={})=>{i.aiming.set(null),i.act("hand",{seat:e,mode:S,...U})},v=lr(`Hand of ${Ut(t,e)}`,Up,S=>{S!=="pull"?(f.hidden=!0,g(S)):(f.hidden=!f.hidden,i.aiming.set(f.hidden?null:{seat:e}))});f.append(F("p",{class:"hint"},"Click in the picture where to pull, or choose a direction:"),F("div",{class:"directions",role:"group","aria-label":"Direction to pull"},...$y.filter(S=>S.from<=(t.scene?.dimension??1)).map(S=>Ye(S.words,()=>{let U=xp(i,e,S.to);U&&g("pull",U)},{class:"button small",label:`Pull ${S.label}`}))));let m=Ye("Take over",()=>{t.take(e),history.replaceState(null,"",hl(e)),i.say(`This page now acts as ${Ut(t,e)}.`)},{class:"button small",tip:"Your pointer moves this user’s hand"}),p=Ye("New window",()=>{open(hl(e),"_blank","noopener")},{class:"button small",tip:"Open another page that acts as this user"}),x=Ye("Stop process",()=>{i.act("kill",{seat:e})},{class:"button small danger",icon:"stop",tip:"Ends this user’s process at once, as a crash would"}),M=Ye("Bring back",()=>{i.act("revive",{seat:e})},{class:"button small",icon:"reset"}),b=[m,p,x,M],C=F("div",{class:"user-more",id:u,hidden:!0},v.element,f,F("div",{class:"actions"},...b)),E=F("li",{class:"user","data-seat":e},d,F("dl",{class:"metrics"},l.element,c.element,h.element),a,C);return{element:E,update:()=>{let S=t.state?.members[e],U=ks(t.state,e);Cn(s,mu[U].icon),Fe(r,mu[U].words),We(E,"data-presence",U),St(o,t.seat===e&&n),We(E,"data-mine",t.seat===e&&n?"":null);let L=U==="here"?S:void 0;Fe(l.value,ol(L?.rate)),Fe(c.value,L?.steps?Rn((L.missed??0)/L.steps):"–"),We(c.element,"data-tip",L?.steps?`${ia(L.missed??0)} of ${ia(L.steps)} steps came late`:null),Fe(h.value,rl(L?.force)),Fe(a,L?Lp[L.hand??"elsewhere"]??"":""),v.mark(L&&n?L.hand:null);let R=i.opened.get()===e;We(d,"aria-expanded",String(R)),St(C,R),R||(f.hidden=!0,i.aiming.get()?.seat===e&&i.aiming.set(null));let O=At(i,"hand")&&n&&U==="here";for(let P of Up)v.allow(P.value,O);m.disabled=!n||t.seat===e,p.disabled=!n;let V=U==="stopped"||U==="gone"&&n;St(x,!V),St(M,V),x.disabled=!At(i,"kill")||!n||U==="awaited",M.disabled=!At(i,"revive")||!n}}}function Fp(i){let{store:e}=i,t=F("span",{class:"panel-note"}),{element:n,body:s}=_i("users","Users",qy,t),r=F("ul",{class:"users"});s.append(r);let o=[],a=()=>{for(let u of o)u.update();let h=e.scene?.users??[];Fe(t,h.length?`${h.filter(u=>ks(e.state,u.seat)==="here").length} of ${h.length} here`:"")},l="",c=()=>{let h=e.scene,u=h?JSON.stringify([h.started,h.users,h.own,h.dimension]):"";if(u===l)return a();l=u,o=(h?.users??[]).map(d=>Yy(i,d.seat)),r.replaceChildren(...o.map(d=>d.element)),a()};e.on("scene",c);for(let h of["state","seat","connection"])e.on(h,a);return i.opened.on(a),c(),n}var Op="cotouch.keys",vu=["displacement","stress","plain"],Jy=[["1 … 8","act as this user"],["G","grab the nearest point; arrows move it, Esc lets go"],["B","grab or push with the ball"],["S","copies overlaid or side by side"],["C","what colours show"],["0","look from the start again"],["F","freeze the plots"],["R","record, stop"],["I","invite"],["T","tour: ← → for steps, Esc leaves"],["D","theme"],["Tab, Enter","reach and open everything, links as well"],["+ −","delay of the link that has the focus"],["?","this page"]];function Zy(i){return i instanceof Element&&i.closest("input, textarea, select, [contenteditable]")!==null}function kp(i,e){let{store:t}=i,n=!1;try{n=localStorage.getItem(Op)==="off"}catch{}let s=F("input",{type:"checkbox"});s.checked=!n,s.addEventListener("change",()=>{n=!s.checked;try{localStorage.setItem(Op,n?"off":"on")}catch{}});let r=Hr("Keyboard",[F("dl",{class:"keys"},...Jy.flatMap(([a,l])=>[F("dt",null,...a.split(" ").map(c=>c==="…"?" … ":F("kbd",null,c))),F("dd",null,l)])),F("label",{class:"check"},s,F("span",null,"Single keys do these things"))],[]),o={b:()=>t.set({tool:t.settings.tool==="grab"?"ball":"grab"}),s:()=>t.set({layout:t.settings.layout==="overlay"?"side":"overlay"}),c:()=>t.set({colour:vu[(vu.indexOf(t.settings.colour)+1)%vu.length]??"plain"}),0:e.reset,f:e.freeze,r:e.record,i:e.invite,t:e.tour,d:()=>fu(t)};return document.addEventListener("keydown",a=>{if(a.defaultPrevented||a.ctrlKey||a.metaKey||a.altKey||a.repeat||Zy(a.target)||document.querySelector("dialog[open]"))return;if(a.key==="?")return a.preventDefault(),r.open();if(n)return;let l=Number(a.key)-1;if(a.key.length===1&&l>=0&&l<8){if(!t.scene?.own.includes(l)){t.scene?.users.some(c=>c.seat===l)&&i.say(`${Ut(t,l)} moves elsewhere; this page cannot act for that user.`,"warn");return}t.take(l),history.replaceState(null,"",hl(l)),i.say(`This page now acts as ${Ut(t,l)}.`);return}o[a.key.toLowerCase()]?.()}),{open:r.open}}var Bp={x:180,y:126},Ky=[.5,.42,.58,.34,.66,.28,.72];function zp(i){let[e,t]=i===2?[104,0]:[104,92];return Array.from({length:i},(n,s)=>{let r=2*Math.PI*s/i+(i===2?Math.PI:-Math.PI/2);return{x:Bp.x+e*Math.cos(r),y:Bp.y+t*Math.sin(r)}})}function ul(i,e,t){return{x:i.x+(e.x-i.x)*t,y:i.y+(e.y-i.y)*t}}function Vp(i,e){let t=[];return i.map(([n,s])=>{let[r,o]=[e[n],e[s]];if(!r||!o)return .5;let a=.5,l=-1/0;for(let c of Ky){let h=ul(r,o,c),u=Math.min(40-40*Math.abs(c-.5),...t.map(d=>Math.hypot((h.x-d.x)*.62,(h.y-d.y)*1.5)),...e.map(d=>Math.hypot(h.x-d.x,h.y-d.y)-6));u>l+.5&&([l,a]=[u,c])}return t.push(ul(r,o,a)),a})}function Gp(i,e){let t=new Set(i.slice(0,1));for(let n=!0;n;){n=!1;for(let[s,r]of e)t.has(s)!==t.has(r)&&(t.add(s).add(r),n=!0)}return i.filter(n=>!t.has(n))}function Hp(i){return i.flatMap((e,t)=>i.slice(t+1).map(n=>e<n?[e,n]:[n,e]))}var yu={start:"As the session began.",best:"Differences between copies fade fastest over these links.",worst:"As many links, but differences fade slowest: watch the copies come back late.",yours:"Click the lines between users to join or part them, then apply."};function jy(i,e,t){for(let[n,s]of[[e,t],[t,e]]){let r=i.members[n]?.paths?.find(([a])=>a===s)?.[1],o=i.ends[`${n}-${s}`]?.path??r;if(typeof o=="number")return Math.max(o,0)}return null}function Wp(i,e){let t=new Map,n=0;for(let[s,r]of e){let o=jy(i,s,r);if(o===null)return null;n+=o;for(let a of[s,r])t.set(a,(t.get(a)??0)+o)}return e.length?{mean:n/e.length,most:Math.max(...t.values())}:null}var xu=i=>(i[0]??"").toUpperCase()+i.slice(1);function dl(i,e){let t=new Set(i.map(Yn));return i.length===e.length&&e.every(n=>t.has(Yn(n)))}var sa=i=>i.map(([e,t])=>Zi(e,t));function Xp(i,e,t,n){let{store:s}=i,r=!1,o=null,a=F("p",{class:"means"}),l=F("p",{class:"expected tabular"}),c=F("p",{class:"problem",role:"status",hidden:!0}),h=M=>M==="yours"?[...e].map(b=>b.split("-").map(Number)):sa(s.state?.choices[M]??[]),u=M=>{if(r=M,e.clear(),M)for(let b of sa(s.state?.links??[]))e.add(Yn(b));t(M)},d=M=>{o=M,M==="yours"?r||u(!0):(r&&u(!1),i.act("links",{choice:M})),n()},f=M=>!!s.state&&M in s.state.choices,g=lr("Links",["start","best","worst","yours"].map(M=>({value:M,words:xu(M),tip:yu[M]})),d),v=Ye("Apply",()=>{let M=h("yours");i.act("links",{links:M}).then(b=>{b&&u(!1)})},{class:"button small primary"}),m=Ye("Cancel",()=>{o=null,u(!1)},{class:"button small"}),p=F("div",{class:"actions",hidden:!0},v,m),x=()=>{let M=s.state,b=sa(M?.links??[]);for(let P of["start","best","worst"]){let H=!f(P)&&At(i,"links");g.allow(P,At(i,"links")&&h(P).length>0),g.say(P,H?`${xu(P)} …`:xu(P),H?"Being worked out; this takes some seconds.":f(P)&&!h(P).length?"None was found.":yu[P])}g.allow("yours",At(i,"links"));let C=r?"yours":o&&o!=="yours"&&dl(h(o),b)?o:["start","best","worst"].find(P=>h(P).length&&dl(h(P),b))??(b.length?"yours":null);g.mark(C);let E=r?h("yours"):b,y=At(i,"links")&&!(f("best")&&f("worst")),S=Object.keys(M?.choices??{}).length>0;St(g.element,S||At(i,"links"));let U=C&&(S||r)?C==="yours"&&!r?"Links of your own.":yu[C]:"";Fe(a,y&&!r?`${U} Best and worst are being worked out.`.trim():U);let[L,R]=M?[Wp(M,sa(M.choices.start??M.links)),Wp(M,E)]:[null,null],O=E.length?`${E.length} ${E.length===1?"link":"links"}`:"";R&&(O+=`, mean way there and back ${kn(R.mean)}`),L&&R&&L.most>0&&!dl(E,sa(M?.choices.start??[]))&&(O+=`. The busiest user needs about ${Qi(R.most/L.most,1)} × the damping of the start, if springs are alike`),Fe(l,O&&`${O}.`),St(p,r);let V=r?Gp((s.scene?.users??[]).map(P=>P.seat),E):[];Fe(c,V.length?`No way leads to ${V.map(P=>Ut(s,P)).join(", ")}.`:""),St(c,V.length>0),v.disabled=V.length>0||dl(E,b)||!At(i,"links"),We(g.element,"data-drafting",r?"":null)};return{element:F("div",{class:"topology",id:"topology"},g.element,a,l,c,p),update:x,changed:n}}var Qy="Who is joined to whom. A number on a link is the age of what its slower end knows of the other, and the share of samples that got lost. Choose a link to see both its ends and to delay, disturb or cut it; draw it sideways to change its delay (1 ms for each point; with the keyboard + and −).",qp=.005,$p=.5,ex=100;function bu(i){let e=null,t=0,n=()=>{if(t=0,e===null)return;let s=e;e=null,t=window.setTimeout(n,ex),i(s)};return s=>{e=s,t||n()}}function tx(i,e,t,n,s){let{store:r}=i,[o,a]=e,[l,c]=[t[o]??{x:0,y:0},t[a]??{x:0,y:0}],h={x1:l.x,y1:l.y,x2:c.x,y2:c.y},u=ul(l,c,n),d=Jt("line",{...h,class:"link-line"}),f=Jt("text",{x:u.x,y:u.y+3.5,class:"link-words"}),g=Jt("rect",{class:"link-plate",rx:4,y:u.y-9,height:18}),v=Jt("g",{class:"link",tabindex:0,role:"button","data-link":Yn(e)},Jt("line",{...h,class:"link-halo"}),d,Jt("line",{...h,class:"link-hit"}),g,f),m=()=>r.state?.emulated[`${o}-${a}`]?.delay??0,p=bu(y=>{i.act("impair",{a:o,b:a,delay:y},!0)}),x=null,M=null;v.addEventListener("pointerdown",y=>{s()||y.button!==0||(M={x:y.clientX,delay:m()},v.setPointerCapture(y.pointerId))}),v.addEventListener("pointermove",y=>{if(!M)return;let S=y.clientX-M.x;x===null&&(Math.abs(S)<4||!At(i,"impair"))||(x=Math.min(Math.max(M.delay+S*.001,0),$p),p(x),E())});let b=y=>{let S=x!==null,U=M!==null;M=x=null,!S&&U&&y.type==="pointerup"&&i.link.set(Ki(i.link.get(),e)?null:e),E()};v.addEventListener("pointerup",b),v.addEventListener("pointercancel",b);let C=0;v.addEventListener("keydown",y=>{if(!s()){if(y.key==="Enter"||y.key===" ")i.link.set(Ki(i.link.get(),e)?null:e),document.getElementById("link")?.focus();else if("+-=−".includes(y.key)&&At(i,"impair"))C=Math.min(Math.max(m()+(y.key==="+"||y.key==="="?qp:-qp),0),$p),p(C);else return;y.preventDefault(),y.stopPropagation()}});let E=()=>{let y=Wr(r.state,o,a),S=Ri(r.state,o,a,"age"),U=Ri(r.state,o,a,"loss");We(v,"data-condition",y),We(v,"data-chosen",Ki(i.link.get(),e)?"":null),We(v,"data-drawn",x===null?null:"");let L=x!==null?`+${kn(x)} each way`:y==="coupled"||y==="catching"||y==="guarded"?[S===null?"":kn(Math.max(S,0)),U!==null&&U>=5e-4?Rn(U):""].filter(Boolean).join(" · ")||"–":oi[y].words,R={guarded:"! ",cut:"✕ ",waiting:"… ",catching:"… "}[y]??"",O=x===null?R+L:L;Fe(f,O);let V=12+O.length*6.1;We(g,"x",(u.x-V/2).toFixed(1)),We(g,"width",V.toFixed(1)),We(v,"aria-label",`Link ${es(o,a)}, ${oi[y].words}, age ${kn(S)}, loss ${Rn(U)}`),We(v,"aria-pressed",String(Ki(i.link.get(),e)))};return{group:v,update:E}}function nx(i,e,t){let{store:n}=i,s=Ut(n,e),r=Math.abs(t.x-360/2)>80,o=t.x>360/2,a=r?10:16,l=s.length>a?`${s.slice(0,a-1)}…`:s,c=r?{x:t.x+(o?1:-1)*24,y:t.y+4,anchor:o?"start":"end"}:{x:t.x,y:t.y+(t.y<248/2?-23:32),anchor:"middle"},h=Jt("g",{class:"node",style:`--user:var(--user-${e});--on-user:var(--on-user-${e})`,"data-seat":e},Jt("title",null,s),Jt("circle",{cx:t.x,cy:t.y,r:20,class:"node-mine"}),Jt("circle",{cx:t.x,cy:t.y,r:16,class:"node-disc"}),Jt("text",{x:t.x,y:t.y+4.5,class:"node-number"},String(e+1)),Jt("text",{x:c.x,y:c.y,"text-anchor":c.anchor,class:"node-name"},l));return h.addEventListener("click",()=>{i.opened.set(e),i.tab.set("users")}),{group:h,update:()=>{We(h,"data-presence",ks(n.state,e)),We(h,"data-mine",n.seat===e&&n.scene?.own.includes(e)?"":null)}}}function ix(i,e,t,n){let[s,r]=[t[e[0]]??{x:0,y:0},t[e[1]]??{x:0,y:0}],o={x1:s.x,y1:s.y,x2:r.x,y2:r.y},a=Yn(e),l=Jt("g",{class:"pair",tabindex:0,role:"checkbox","aria-label":`Link ${es(...e)}`,"data-link":a},Jt("line",{...o,class:"pair-line"}),Jt("line",{...o,class:"link-hit"})),c=()=>{i.delete(a)||i.add(a),n()};return l.addEventListener("click",c),l.addEventListener("keydown",h=>{h.key!=="Enter"&&h.key!==" "||(h.preventDefault(),c())}),{group:l,update:()=>We(l,"aria-checked",String(i.has(a)))}}function Jp(i){let{store:e}=i,{element:t,body:n}=_i("network","Network",Qy),s=Jt("svg",{viewBox:`0 0 ${360} ${248}`,class:"graph",role:"group","aria-label":"Users and links"}),r=F("ul",{class:"legend"},...["coupled","guarded","cut"].map(d=>F("li",{"data-condition":d,"data-tip":oi[d].means,tabindex:0},an(oi[d].icon,12),oi[d].words))),o=new Set,a=!1,l=[],c="",h=()=>{let d=(e.scene?.users??[]).map(v=>v.seat),f=(e.state?.links??[]).map(([v,m])=>Zi(v,m)),g=JSON.stringify([a,e.scene?.started,e.scene?.users,f]);if(g!==c){c=g;let v=document.activeElement?.closest("[data-link]")?.dataset.link,m=[];zp(d.length).forEach((b,C)=>{m[d[C]??C]=b});let p=Vp(f,m);l=[...a?Hp(d).map(b=>ix(o,b,m,()=>u.changed())):f.map((b,C)=>tx(i,b,m,p[C]??.5,()=>a)),...d.map(b=>nx(i,b,m[b]??{x:0,y:0}))],s.replaceChildren(...l.map(b=>b.group)),We(s,"data-drafting",a?"":null),v&&s.querySelector(`[data-link="${v}"]`)?.focus();let M=i.link.get();M&&!f.some(b=>Ki(b,M))&&i.link.set(null)}for(let v of l)v.update();u.update(),St(r,!a)},u=Xp(i,o,d=>{a=d,d&&i.link.set(null),h()},()=>h());n.append(s,r,u.element);for(let d of["scene","state","seat","connection"])e.on(d,h);return i.link.on(h),h(),t}var Mu=[{words:"state",tip:"What this end does with its spring",show:i=>oi[ll(i)].words},{words:"age",tip:"Of the newest sample in the last step, up to the offset of the two clocks",show:i=>kn(i.age)},{words:"both ages",tip:"Greatest sum of the ages at both ends in the window; here clocks cancel",show:i=>kn(i.ages)},{words:"budget",tip:"What the damping is made for: the sum of ages that may be",show:i=>kn(i.budget)},{words:"way",tip:"Quickest way there and back",show:i=>`${kn(i.path)} ${i.way}`},{words:"loss",tip:"Share of what the neighbour sent that did not come",show:i=>Rn(i.loss)},{words:"samples",tip:"Sent to the neighbour per second",show:i=>ol(i.rate)},{words:"force",tip:"Of the link’s spring on this copy",show:i=>rl(i.force)},{words:"work",tip:"Of the link on this copy since the start",show:i=>Vr(i.work,"J")},{words:"apart",tip:"Greatest difference between the copies, as far as known",show:i=>Mp(i.difference)},{words:"guarded",tip:"How often the link was guarded",show:i=>`${ia(i.guarded)} ×`}];function Su(i,e,t,n){let s=F("output",{class:"tabular"},t.show(0)),r=F("input",{type:"range",min:0,max:t.most,step:t.step,value:0,"aria-label":i}),o=-1/0,a=bu(n),l=()=>{let c=Number(r.value);Fe(s,t.show(c)),We(r,"aria-valuetext",t.show(c)),r.style.setProperty("--share",`${100*c/t.most}%`)};return r.addEventListener("input",()=>{o=performance.now(),l(),a(Number(r.value))}),{element:F("label",{class:"slider","data-tip":e},F("span",null,i),r,s),set(c){performance.now()-o<1e3||Number(r.value)===c||(r.value=String(c),l())},enable(c){r.disabled=!c}}}function Zp(i){let{store:e}=i,t=[0,1],n=F("h2",{id:"link-title",class:"tabular"}),s=an("good",14),r=F("strong",null),o=F("span",{class:"means"}),a=F("p",{class:"expected tabular"}),l=x=>M=>{i.act("impair",{a:t[0],b:t[1],[x]:M},!0)},c={delay:Su("delay","Added to every sample, each way",{most:.5,step:.005,show:kn},l("delay")),jitter:Su("jitter","Scale of what comes on top of the delay by chance",{most:.1,step:.002,show:kn},l("jitter")),loss:Su("loss","Share of samples thrown away",{most:.5,step:.01,show:x=>Rn(x,0)},l("loss"))},h=Ye("Cut",()=>{let x=!(e.state&&hr(e.state,...t));i.act("cut",{a:t[0],b:t[1],on:x})},{icon:"cut",class:"button",id:"cut"}),u=Ye("Clear",()=>{i.act("impair",{a:t[0],b:t[1],delay:0,jitter:0,loss:0})},{class:"button",icon:"reset",tip:"No added delay, jitter or loss"}),d=[F("th",{scope:"col"}),F("th",{scope:"col"})],f=Mu.map(()=>[F("td"),F("td")]),g=F("table",{class:"numbers"},F("thead",null,F("tr",null,F("td"),...d)),F("tbody",null,...Mu.map((x,M)=>F("tr",null,F("th",{scope:"row","data-tip":x.tip,tabindex:0},x.words),...f[M]??[])))),v=Ye("",()=>i.link.set(null),{icon:"close",class:"button bare",label:"Close the link’s card"}),m=F("aside",{id:"link",class:"card","aria-labelledby":"link-title",tabindex:-1,hidden:!0},F("div",{class:"panel-head"},n,F("div",{class:"grow"}),v),F("p",{class:"condition"},s,r," ",o),a,c.delay.element,c.jitter.element,c.loss.element,F("div",{class:"actions"},h,u),g);m.addEventListener("keydown",x=>{if(x.key!=="Escape")return;let M=document.querySelector(`.link[data-link="${t.join("-")}"]`);i.link.set(null),M?.focus(),x.stopPropagation()});let p=()=>{let x=i.link.get();if(St(m,x!==null),!x)return;t=x;let[M,b]=t,C=Wr(e.state,M,b);Fe(n,`Link ${es(M,b)}`),We(m,"data-condition",C),Cn(s,oi[C].icon),Fe(r,oi[C].words),Fe(o,oi[C].means);let E=cl(e.state,M,b);Fe(a,E===null||C==="cut"?"":E>=0?`${Rn(E,0)} of the budget of ages to spare.`:`Ages are ${Rn(-E,0)} over the budget.`);let y=e.state?.emulated[`${M}-${b}`];c.delay.set(y?.delay??0),c.jitter.set(y?.jitter??0),c.loss.set(y?.loss??0);for(let L of Object.values(c))L.enable(At(i,"impair"));u.disabled=!At(i,"impair");let S=!!e.state&&hr(e.state,M,b);Fe(h.lastElementChild??h,S?"Mend":"Cut");let U=h.querySelector("svg");U&&Cn(U,S?"mend":"cut"),We(h,"class",S?"button primary":"button danger"),h.disabled=!At(i,"cut"),[[M,b],[b,M]].forEach(([L,R],O)=>{let V=d[O];V&&(Fe(V,`at ${(L??0)+1}`),We(V,"title",Ut(e,L??0)),V.style.setProperty("--user",`var(--user-${L})`));let P=e.state?.ends[`${L}-${R}`];Mu.forEach((H,Y)=>{let k=f[Y]?.[O];k&&Fe(k,P?H.show(P):"–")})})};return e.on("state",p),e.on("scene",p),e.on("connection",p),i.link.on(x=>{p(),x&&(m.scrollTop=0)}),m}var sx="uplot",rx="u-hz",ox="u-vt",ax="u-title",lx="u-wrap",cx="u-under",hx="u-over",ux="u-axis",fr="u-off",dx="u-select",fx="u-cursor-x",px="u-cursor-y",mx="u-cursor-pt",gx="u-legend",vx="u-live",yx="u-inline",xx="u-series",_x="u-marker",Kp="u-label",bx="u-value",aa="width",la="height";var jp="bottom",Xr="left",wu="right",Vu="#000",Qp=Vu+"0",Eu="mousemove",em="mousedown",Tu="mouseup",tm="mouseenter",nm="mouseleave",im="dblclick",Mx="resize",Sx="scroll",sm="change",vl="dppxchange",Gu="--",jr=typeof window<"u",Iu=jr?document:null,$r=jr?window:null,wx=jr?navigator:null,Tt,fl;function Lu(){let i=devicePixelRatio;Tt!=i&&(Tt=i,fl&&Du(sm,fl,Lu),fl=matchMedia(`(min-resolution: ${Tt-.001}dppx) and (max-resolution: ${Tt+.001}dppx)`),pr(sm,fl,Lu),$r.dispatchEvent(new CustomEvent(vl)))}function ai(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Nu(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Xt(i,e,t){i.style[e]=t+"px"}function Pi(i,e,t,n){let s=Iu.createElement(i);return e!=null&&ai(s,e),t?.insertBefore(s,n),s}function bi(i,e){return Pi("div",i,e)}var rm=new WeakMap;function ns(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=rm.get(i);r!=o&&(i.style.transform=r,rm.set(i,r),e<0||t<0||e>n||t>s?ai(i,fr):Nu(i,fr))}var om=new WeakMap;function am(i,e,t){let n=e+t,s=om.get(i);n!=s&&(om.set(i,n),i.style.background=e,i.style.borderColor=t)}var lm=new WeakMap;function cm(i,e,t,n){let s=e+""+t,r=lm.get(i);s!=r&&(lm.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Hu={passive:!0},Ex={...Hu,capture:!0};function pr(i,e,t,n){e.addEventListener(i,t,n?Ex:Hu)}function Du(i,e,t,n){e.removeEventListener(i,t,Hu)}jr&&Lu();function Ii(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:li((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Om(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var km=i=>i!=null,Bm=i=>i!=null&&i>0,_l=Om(km),Tx=Om(Bm);function Ax(i,e,t,n=0,s=!1){let r=s?Tx:_l,o=s?Bm:km;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ot,l??-Ot]}function bl(i,e,t,n){let s=dm(i),r=dm(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?ms:zm,a=s==1?li:Mi,l=r==1?Mi:li,c=a(o(_n(i))),h=l(o(_n(e))),u=Yr(t,c),d=Yr(t,h);return t==10&&(c<0&&(u=kt(u,-c)),h<0&&(d=kt(d,-h))),n||t==2?(i=u*s,e=d*r):(i=Wm(i,u),e=Ml(e,d)),[i,e]}function Wu(i,e,t,n){let s=bl(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Xu=.1,hm={mode:3,pad:Xu},ha={pad:0,soft:null,mode:0},Cx={min:ha,max:ha};function yl(i,e,t,n){return Sl(t)?um(i,e,t):(ha.pad=t,ha.soft=n?0:null,ha.mode=n?3:0,um(i,e,Cx))}function wt(i,e){return i??e}function Rx(i,e,t){for(e=wt(e,0),t=wt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function um(i,e,t){let n=t.min,s=t.max,r=wt(n.pad,0),o=wt(s.pad,0),a=wt(n.hard,-Ot),l=wt(s.hard,Ot),c=wt(n.soft,Ot),h=wt(s.soft,-Ot),u=wt(n.mode,0),d=wt(s.mode,0),f=e-i,g=ms(f),v=Jn(_n(i),_n(e)),m=ms(v),p=_n(m-g);(f<1e-24||p>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=Ot&&(r=0),d==2&&h!=-Ot&&(o=0)));let x=f||v||1e3,M=ms(x),b=Yr(10,li(M)),C=x*(f==0?i==0?.1:1:r),E=kt(Wm(i-C,b/10),24),y=i>=c&&(u==1||u==3&&E<=c||u==2&&E>=c)?c:Ot,S=Jn(a,E<y&&i>=y?y:Li(y,E)),U=x*(f==0?e==0?.1:1:o),L=kt(Ml(e+U,b/10),24),R=e<=h&&(d==1||d==3&&L>=h||d==2&&L<=h)?h:-Ot,O=Li(l,L>R&&e<=R?R:Jn(R,L));return S==O&&S==0&&(O=100),[S,O]}var Px=new Intl.NumberFormat(jr?wx.language:"en-US"),qu=i=>Px.format(i),ci=Math,gl=ci.PI,_n=ci.abs,li=ci.floor,xn=ci.round,Mi=ci.ceil,Li=ci.min,Jn=ci.max,Yr=ci.pow,dm=ci.sign,ms=ci.log10,zm=ci.log2,Ix=(i,e=1)=>ci.sinh(i)*e,Au=(i,e=1)=>ci.asinh(i/e),Ot=1/0;function fm(i){return(ms((i^i>>31)-(i>>31))|0)+1}function Uu(i,e,t){return Li(Jn(i,e),t)}function Vm(i){return typeof i=="function"}function gt(i){return Vm(i)?i:()=>i}var Lx=()=>{},Gm=i=>i,Hm=(i,e)=>e,Nx=i=>null,pm=i=>!0,mm=(i,e)=>i==e,Dx=/\.\d*?(?=9{6,}|0{6,})/gm,mr=i=>{if(qm(i)||zs.has(i))return i;let e=`${i}`,t=e.match(Dx);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${mr(s)}e${r}`}return kt(i,n)};function ur(i,e){return mr(kt(mr(i/e))*e)}function Ml(i,e){return mr(Mi(mr(i/e))*e)}function Wm(i,e){return mr(li(mr(i/e))*e)}function kt(i,e=0){if(qm(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return xn(n)/t}var zs=new Map;function Xm(i){return((""+i).split(".")[1]||"").length}function da(i,e,t,n){let s=[],r=n.map(Xm);for(let o=e;o<t;o++){let a=_n(o),l=kt(Yr(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:kt(h,u);s.push(d),zs.set(d,u)}}return s}var ua={},$u=[],Jr=[null,null],Bs=Array.isArray,qm=Number.isInteger,Ux=i=>i===void 0;function gm(i){return typeof i=="string"}function Sl(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function Fx(i){return i!=null&&typeof i=="object"}var Ox=Object.getPrototypeOf(Uint8Array),$m="__proto__";function Zr(i,e=Sl){let t;if(Bs(i)){let n=i.find(s=>s!=null);if(Bs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Zr(i[s],e)}else t=i.slice()}else if(i instanceof Ox)t=i.slice();else if(e(i)){t={};for(let n in i)n!=$m&&(t[n]=Zr(i[n],e))}else t=i;return t}function mn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=$m&&(Sl(i[s])?mn(i[s],Zr(n[s])):i[s]=Zr(n[s]))}return i}var kx=0,Bx=1,zx=2;function Vx(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function Gx(i,e){if(Xx(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return qx(o[0])||(o=Wx(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:Bx,f=[];for(let g=0;g<h.length;g++){let v=h[g],m=r.get(l[g]);v===null?d!=kx&&(u[m]=v,d==zx&&f.push(m)):u[m]=v}Vx(u,f,s),n.push(u)}}return n}var Hx=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Wx(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function Xx(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function qx(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Jn(1,li((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Ym=["January","February","March","April","May","June","July","August","September","October","November","December"],Jm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Zm(i){return i.slice(0,3)}var $x=Jm.map(Zm),Yx=Ym.map(Zm),Jx={MMMM:Ym,MMM:Yx,WWWW:Jm,WWW:$x};function oa(i){return(i<10?"0":"")+i}function Zx(i){return(i<10?"00":i<100?"0":"")+i}var Kx={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>oa(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>oa(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>oa(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>oa(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>oa(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Zx(i.getMilliseconds())};function Yu(i,e){e=e||Jx;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?Kx[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var jx=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Qx(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==jx?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Km=i=>i%1==0,xl=[1,2,2.5,5],e_=da(10,-32,0,xl),jm=da(10,0,32,xl),t_=jm.filter(Km),dr=e_.concat(jm),Ju=`
`,Qm="{YYYY}",vm=Ju+Qm,eg="{M}/{D}",ca=Ju+eg,pl=ca+"/{YY}",tg="{aa}",n_="{h}:{mm}",qr=n_+tg,ym=Ju+qr,xm=":{ss}",Ct=null;function ng(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?da(10,0,3,xl).filter(Km):da(10,-3,0,xl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Qm,Ct,Ct,Ct,Ct,Ct,Ct,1],[s*28,"{MMM}",vm,Ct,Ct,Ct,Ct,Ct,1],[s,eg,vm,Ct,Ct,Ct,Ct,Ct,1],[n,"{h}"+tg,pl,Ct,ca,Ct,Ct,Ct,1],[t,qr,pl,Ct,ca,Ct,Ct,Ct,1],[e,xm,pl+" "+qr,Ct,ca+" "+qr,Ct,ym,Ct,1],[i,xm+".{fff}",pl+" "+qr,Ct,ca+" "+qr,Ct,ym,Ct,1]];function h(u){return(d,f,g,v,m,p)=>{let x=[],M=m>=o,b=m>=r&&m<o,C=u(g),E=kt(C*i,3),y=Cu(C.getFullYear(),M?0:C.getMonth(),b||M?1:C.getDate()),S=kt(y*i,3);if(b||M){let U=b?m/r:0,L=M?m/o:0,R=E==S?E:kt(Cu(y.getFullYear()+L,y.getMonth()+U,1)*i,3),O=new Date(xn(R/i)),V=O.getFullYear(),P=O.getMonth();for(let H=0;R<=v;H++){let Y=Cu(V+L*H,P+U*H,1),k=Y-u(kt(Y*i,3));R=kt((+Y+k)*i,3),R<=v&&x.push(R)}}else{let U=m>=s?s:m,L=li(g)-li(E),R=S+L+Ml(E-S,U);x.push(R);let O=u(R),V=O.getHours()+O.getMinutes()/t+O.getSeconds()/n,P=m/n,H=d.axes[f]._space,Y=p/H;for(;R=kt(R+m,i==1?0:3),!(R>v);)if(P>1){let k=li(kt(V+P,6))%24,j=u(R).getHours()-k;j>1&&(j=-1),R-=j*n,V=(V+P)%24;let te=x[x.length-1];kt((R-te)/m,3)*Y>=.7&&x.push(R)}else x.push(R)}return x}}return[l,c,h]}var[i_,s_,r_]=ng(1),[o_,a_,l_]=ng(.001);da(2,-53,53,[1]);function _m(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function bm(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,u,d,f;return n.map(g=>{let v=i(g),m=v.getFullYear(),p=v.getMonth(),x=v.getDate(),M=v.getHours(),b=v.getMinutes(),C=v.getSeconds(),E=m!=l&&a[2]||p!=c&&a[3]||x!=h&&a[4]||M!=u&&a[5]||b!=d&&a[6]||C!=f&&a[7]||a[1];return l=m,c=p,h=x,u=M,d=b,f=C,E(v)})}}function c_(i,e){let t=Yu(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Cu(i,e,t){return new Date(i,e,t)}function Mm(i,e){return e(i)}var h_="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Sm(i,e){return(t,n,s,r)=>r==null?Gu:e(i(n))}function u_(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function d_(i,e){return i.series[e].fill(i,e)}var f_={show:!0,live:!0,isolate:!1,mount:Lx,markers:{show:!0,width:2,stroke:u_,fill:d_,dash:"solid"},idx:null,idxs:null,values:[]};function p_(i,e){let t=i.cursor.points,n=bi(),s=t.size(i,e);Xt(n,aa,s),Xt(n,la,s);let r=s/-2;Xt(n,"marginLeft",r),Xt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Xt(n,"borderWidth",o),n}function m_(i,e){let t=i.series[e].points;return t._fill||t._stroke}function g_(i,e){let t=i.series[e].points;return t._stroke||t._fill}function v_(i,e){return i.series[e].points.size}var Ru=[0,0];function y_(i,e,t){return Ru[0]=e,Ru[1]=t,Ru}function ml(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Pu(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var x_={show:!0,x:!0,y:!0,lock:!1,move:y_,points:{one:!1,show:p_,size:v_,width:0,stroke:g_,fill:m_},bind:{mousedown:ml,mouseup:ml,click:ml,dblclick:ml,mousemove:Pu,mouseleave:Pu,mouseenter:Pu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},ig={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Zu=mn({},ig,{filter:Hm}),sg=mn({},Zu,{size:10}),rg=mn({},ig,{show:!1}),Ku='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',og="bold "+Ku,ag=1.5,wm={show:!0,scale:"x",stroke:Vu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:og,side:2,grid:Zu,ticks:sg,border:rg,font:Ku,lineGap:ag,rotate:0},__="Value",b_="Time",Em={show:!0,scale:"x",auto:!1,sorted:1,min:Ot,max:-Ot,idxs:[]};function M_(i,e,t,n,s){return e.map(r=>r==null?"":qu(r))}function S_(i,e,t,n,s,r,o){let a=[],l=zs.get(s)||0;t=o?t:kt(Ml(t,s),l);for(let c=t;c<=n;c=kt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Fu(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?ms:zm,h=li(c(t));s=Yr(l,h),l==10&&(s=dr[Ii(s,dr)]);let u=t,d=s*l;l==10&&(d=dr[Ii(d,dr)]);do a.push(u),u=u+s,l==10&&!zs.has(u)&&(u=kt(u,zs.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=dr[Ii(d,dr)]));while(u<=n);return a}function w_(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?Fu(i,e,Jn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?Fu(i,e,Jn(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var lg=/./,E_=/[12357]/,T_=/[125]/,Tm=/1/,Ou=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function A_(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?lg:l(7,o)-h>=c?E_:l(5,o)-h>=c?T_:Tm;if(u==Tm){let d=_n(l(1,o)-h);if(d<c)return Ou(e.slice().reverse(),a.distr,u,Mi(c/d)).reverse()}return Ou(e,a.distr,u,1)}function C_(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=_n(l(1,o)-l(2,o));return c<a?Ou(e.slice().reverse(),3,lg,Mi(a/c)).reverse():e}function R_(i,e,t,n){return n==null?Gu:e==null?"":qu(e)}var Am={show:!0,scale:"y",stroke:Vu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:og,side:3,grid:Zu,ticks:sg,border:rg,font:Ku,lineGap:ag,rotate:0};function P_(i,e){let t=3+(i||1)*2;return kt(t*e,3)}function I_(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=_n(o-r),l=i.series[e],c=a/(l.points.space*Tt);return n[1]-n[0]<=c}var Cm={scale:null,auto:!0,sorted:0,min:Ot,max:-Ot},cg=(i,e,t,n,s)=>s,Rm={show:!0,auto:!0,sorted:0,gaps:cg,alpha:1,facets:[mn({},Cm,{scale:"x"}),mn({},Cm,{scale:"y"})]},Pm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:cg,alpha:1,points:{show:I_,filter:null},values:null,min:Ot,max:-Ot,idxs:[],path:null,clip:null};function L_(i,e,t,n,s){return t/10}var hg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},N_=mn({},hg,{time:!1,ori:1}),Im={};function ug(i,e){let t=Im[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Im[i]=t)),t}var Kr=1,ku=2;function gr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,v=a.height,m=i.valToPosH,p=i.valToPosV;return h.ori==0?t(s,l,c,h,u,m,p,d,f,g,v,El,Qr,Al,fg,mg):t(s,l,c,h,u,p,m,f,d,v,g,Tl,eo,ed,pg,gg)}function ju(i,e){let t=0,n=0,s=wt(i.bands,$u);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function D_(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function gs(i,e,t,n,s,r){return gr(i,e,(o,a,l,c,h,u,d,f,g,v,m)=>{let p=o.pxRound,x=c.dir*(c.ori==0?1:-1),M=c.ori==0?Qr:eo,b,C;x==1?(b=t,C=n):(b=n,C=t);let E=p(u(a[b],c,v,f)),y=p(d(l[b],h,m,g)),S=p(u(a[C],c,v,f)),U=p(d(r==1?h.max:h.min,h,m,g)),L=new Path2D(s);return M(L,S,U),M(L,E,U),M(L,E,y),L})}function wl(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Al:ed,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function U_(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Qu(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[u]),g=d==u?f:r(i[d]),v=u-s;f=o<=0&&v>=0&&v<l?r(i[v]):f;let p=d+s;g=o>=0&&p>=0&&p<l?r(i[p]):g,g>=f&&a.push([f,g])}return a}function Lm(i){return i==0?Gm:i==1?xn:e=>ur(e,i)}function dg(i){let e=i==0?El:Tl,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Li(c,a/2,l/2),h=Li(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var El=(i,e,t)=>{i.moveTo(e,t)},Tl=(i,e,t)=>{i.moveTo(t,e)},Qr=(i,e,t)=>{i.lineTo(e,t)},eo=(i,e,t)=>{i.lineTo(t,e)},Al=dg(0),ed=dg(1),fg=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},pg=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},mg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},gg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function vg(i){return(e,t,n,s,r)=>gr(e,t,(o,a,l,c,h,u,d,f,g,v,m)=>{let{pxRound:p,points:x}=o,M,b;c.ori==0?(M=El,b=fg):(M=Tl,b=pg);let C=kt(x.width*Tt,3),E=(x.size-x.width)/2*Tt,y=kt(E*2,3),S=new Path2D,U=new Path2D,{left:L,top:R,width:O,height:V}=e.bbox;Al(U,L-y,R-y,O+y*2,V+y*2);let P=H=>{if(l[H]!=null){let Y=p(u(a[H],c,v,f)),k=p(d(l[H],h,m,g));M(S,Y+E,k),b(S,Y,k,E,0,gl*2)}};if(r)r.forEach(P);else for(let H=n;H<=s;H++)P(H);return{stroke:C>0?S:null,fill:S,clip:U,flags:Kr|ku}})}function yg(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var F_=yg(Qr),O_=yg(eo);function xg(i){let e=wt(i?.alignGaps,0);return(t,n,s,r)=>gr(t,n,(o,a,l,c,h,u,d,f,g,v,m)=>{[s,r]=_l(l,s,r);let p=o.pxRound,x=V=>p(u(V,c,v,f)),M=V=>p(d(V,h,m,g)),b,C;c.ori==0?(b=Qr,C=F_):(b=eo,C=O_);let E=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Kr},S=y.stroke,U=!1;if(r-s>=v*4){let V=ue=>t.posToVal(ue,c.key,!0),P=null,H=null,Y,k,re,q=x(a[E==1?s:r]),j=x(a[s]),te=x(a[r]),de=V(E==1?j+1:te-1);for(let ue=E==1?s:r;ue>=s&&ue<=r;ue+=E){let ee=a[ue],ye=(E==1?ee<de:ee>de)?q:x(ee),Ae=l[ue];ye==q?Ae!=null?(k=Ae,P==null?(b(S,ye,M(k)),Y=P=H=k):k<P?P=k:k>H&&(H=k)):Ae===null&&(U=!0):(P!=null&&C(S,q,M(P),M(H),M(Y),M(k)),Ae!=null?(k=Ae,b(S,ye,M(k)),P=H=Y=k):(P=H=null,Ae===null&&(U=!0)),q=ye,de=V(q+E))}P!=null&&P!=H&&re!=q&&C(S,q,M(P),M(H),M(Y),M(k))}else for(let V=E==1?s:r;V>=s&&V<=r;V+=E){let P=l[V];P===null?U=!0:P!=null&&b(S,x(a[V]),M(P))}let[R,O]=ju(t,n);if(o.fill!=null||R!=0){let V=y.fill=new Path2D(S),P=o.fillTo(t,n,o.min,o.max,R),H=M(P),Y=x(a[s]),k=x(a[r]);E==-1&&([k,Y]=[Y,k]),b(V,k,H),b(V,Y,H)}if(!o.spanGaps){let V=[];U&&V.push(...Qu(a,l,s,r,E,x,e)),y.gaps=V=o.gaps(t,n,s,r,V),y.clip=wl(V,c.ori,f,g,v,m)}return O!=0&&(y.band=O==2?[gs(t,n,s,r,S,-1),gs(t,n,s,r,S,1)]:gs(t,n,s,r,S,O)),y})}function k_(i){let e=wt(i.align,1),t=wt(i.ascDesc,!1),n=wt(i.alignGaps,0),s=wt(i.extend,!1);return(r,o,a,l)=>gr(r,o,(c,h,u,d,f,g,v,m,p,x,M)=>{[a,l]=_l(u,a,l);let b=c.pxRound,{left:C,width:E}=r.bbox,y=j=>b(g(j,d,x,m)),S=j=>b(v(j,f,M,p)),U=d.ori==0?Qr:eo,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Kr},R=L.stroke,O=d.dir*(d.ori==0?1:-1),V=S(u[O==1?a:l]),P=y(h[O==1?a:l]),H=P,Y=P;s&&e==-1&&(Y=C,U(R,Y,V)),U(R,P,V);for(let j=O==1?a:l;j>=a&&j<=l;j+=O){let te=u[j];if(te==null)continue;let de=y(h[j]),ue=S(te);e==1?U(R,de,V):U(R,H,ue),U(R,de,ue),V=ue,H=de}let k=H;s&&e==1&&(k=C+E,U(R,k,V));let[re,q]=ju(r,o);if(c.fill!=null||re!=0){let j=L.fill=new Path2D(R),te=c.fillTo(r,o,c.min,c.max,re),de=S(te);U(j,k,de),U(j,Y,de)}if(!c.spanGaps){let j=[];j.push(...Qu(h,u,a,l,O,y,n));let te=c.width*Tt/2,de=t||e==1?te:-te,ue=t||e==-1?-te:te;j.forEach(ee=>{ee[0]+=de,ee[1]+=ue}),L.gaps=j=c.gaps(r,o,a,l,j),L.clip=wl(j,d.ori,m,p,x,M)}return q!=0&&(L.band=q==2?[gs(r,o,a,l,R,-1),gs(r,o,a,l,R,1)]:gs(r,o,a,l,R,q)),L})}function Nm(i,e,t,n,s,r,o=Ot){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=_n(i[l]-i[a]);h<c&&(c=h,o=_n(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function B_(i){i=i||ua;let e=wt(i.size,[.6,Ot,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=gt(s),o=1-e[0],a=wt(e[1],Ot),l=wt(e[2],1),c=wt(i.disp,ua),h=wt(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,g,v,m)=>gr(f,g,(p,x,M,b,C,E,y,S,U,L,R)=>{let O=p.pxRound,V=t,P=n*Tt,H=a*Tt,Y=l*Tt,k,re;b.ori==0?[k,re]=r(f,g):[re,k]=r(f,g);let q=b.dir*(b.ori==0?1:-1),j=b.ori==0?Al:ed,te=b.ori==0?h:(Re,Je,ot,Se,Ft,Ve,$e)=>{h(Re,Je,ot,Ft,Se,$e,Ve)},de=wt(f.bands,$u).find(Re=>Re.series[0]==g),ue=de!=null?de.dir:0,ee=p.fillTo(f,g,p.min,p.max,ue),me=O(y(ee,C,R,U)),ye,Ae,Me,Xe=L,rt=O(p.width*Tt),Ge=!1,ut=null,lt=null,it=null,$t=null;u!=null&&(rt==0||d!=null)&&(Ge=!0,ut=u.values(f,g,v,m),lt=new Map,new Set(ut).forEach(Re=>{Re!=null&&lt.set(Re,new Path2D)}),rt>0&&(it=d.values(f,g,v,m),$t=new Map,new Set(it).forEach(Re=>{Re!=null&&$t.set(Re,new Path2D)})));let{x0:Bt,size:cn}=c;if(Bt!=null&&cn!=null){V=1,x=Bt.values(f,g,v,m),Bt.unit==2&&(x=x.map(ot=>f.posToVal(S+ot*L,b.key,!0)));let Re=cn.values(f,g,v,m);cn.unit==2?Ae=Re[0]*L:Ae=E(Re[0],b,L,S)-E(0,b,L,S),Xe=Nm(x,M,E,b,L,S,Xe),Me=Xe-Ae+P}else Xe=Nm(x,M,E,b,L,S,Xe),Me=Xe*o+P,Ae=Xe-Me;Me<1&&(Me=0),rt>=Ae/2&&(rt=0),Me<5&&(O=Gm);let Nt=Me>0,Sn=Xe-Me-(Nt?rt:0);Ae=O(Uu(Sn,Y,H)),ye=(V==0?Ae/2:V==q?0:Ae)-V*q*((V==0?P/2:0)+(Nt?rt/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},vn=Ge?null:new Path2D,Qt=null;if(de!=null)Qt=f.data[de.series[1]];else{let{y0:Re,y1:Je}=c;Re!=null&&Je!=null&&(M=Je.values(f,g,v,m),Qt=Re.values(f,g,v,m))}let hn=k*Ae,z=re*Ae;for(let Re=q==1?v:m;Re>=v&&Re<=m;Re+=q){let Je=M[Re];if(Je==null)continue;if(Qt!=null){let $=Qt[Re]??0;if(Je-$==0)continue;me=y($,C,R,U)}let ot=b.distr!=2||c!=null?x[Re]:Re,Se=E(ot,b,L,S),Ft=y(wt(Je,ee),C,R,U),Ve=O(Se-ye),$e=O(Jn(Ft,me)),I=O(Li(Ft,me)),w=$e-I;if(Je!=null){let $=Je<0?z:hn,he=Je<0?hn:z;Ge?(rt>0&&it[Re]!=null&&j($t.get(it[Re]),Ve,I+li(rt/2),Ae,Jn(0,w-rt),$,he),ut[Re]!=null&&j(lt.get(ut[Re]),Ve,I+li(rt/2),Ae,Jn(0,w-rt),$,he)):j(vn,Ve,I+li(rt/2),Ae,Jn(0,w-rt),$,he),te(f,g,Re,Ve-rt/2,I,Ae+rt,w)}}return rt>0?bt.stroke=Ge?$t:vn:Ge||(bt._fill=p.width==0?p._fill:p._stroke??p._fill,bt.width=0),bt.fill=Ge?lt:vn,bt})}function z_(i,e){let t=wt(e?.alignGaps,0);return(n,s,r,o)=>gr(n,s,(a,l,c,h,u,d,f,g,v,m,p)=>{[r,o]=_l(c,r,o);let x=a.pxRound,M=k=>x(d(k,h,m,g)),b=k=>x(f(k,u,p,v)),C,E,y;h.ori==0?(C=El,y=Qr,E=mg):(C=Tl,y=eo,E=gg);let S=h.dir*(h.ori==0?1:-1),U=M(l[S==1?r:o]),L=U,R=[],O=[];for(let k=S==1?r:o;k>=r&&k<=o;k+=S)if(c[k]!=null){let q=l[k],j=M(q);R.push(L=j),O.push(b(c[k]))}let V={stroke:i(R,O,C,y,E,x),fill:null,clip:null,band:null,gaps:null,flags:Kr},P=V.stroke,[H,Y]=ju(n,s);if(a.fill!=null||H!=0){let k=V.fill=new Path2D(P),re=a.fillTo(n,s,a.min,a.max,H),q=b(re);y(k,L,q),y(k,U,q)}if(!a.spanGaps){let k=[];k.push(...Qu(l,c,r,o,S,M,t)),V.gaps=k=a.gaps(n,s,r,o,k),V.clip=wl(k,h.ori,g,v,m,p)}return Y!=0&&(V.band=Y==2?[gs(n,s,r,o,P,-1),gs(n,s,r,o,P,1)]:gs(n,s,r,o,P,Y)),V})}function V_(i){return z_(G_,i)}function G_(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var Bu=new Set;function Dm(){for(let i of Bu)i.syncRect(!0)}jr&&(pr(Mx,$r,Dm),pr(Sx,$r,Dm,!0),pr(vl,$r,()=>{Nn.pxRatio=Tt}));var H_=xg(),W_=vg();function Um(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>zu(r,o,e,t))}function X_(i,e){return i.map((t,n)=>n==0?{}:mn({},e,t))}function zu(i,e,t,n){return mn({},e==0?t:n,i)}function _g(i,e,t){return e==null?Jr:[e,t]}var q_=_g;function $_(i,e,t){return e==null?Jr:yl(e,t,Xu,!0)}function bg(i,e,t,n){return e==null?Jr:bl(e,t,i.scales[n].log,!1)}var Y_=bg;function Mg(i,e,t,n){return e==null?Jr:Wu(e,t,i.scales[n].log,!1)}var J_=Mg;function Z_(i,e,t,n,s){let r=Jn(fm(i),fm(e)),o=e-i,a=Ii(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?zs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Fm(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=xn((t=+s)*Tt))+"px"),[i,e,t]}function K_(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=kt(e[2]*Tt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Nn(i,e,t){let n={mode:wt(i.mode,1)},s=n.mode;function r(_,T,N,D){let X=T.valToPct(_);return D+N*(T.dir==-1?1-X:X)}function o(_,T,N,D){let X=T.valToPct(_);return D+N*(T.dir==-1?X:1-X)}function a(_,T,N,D){return T.ori==0?r(_,T,N,D):o(_,T,N,D)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=bi(sx);if(i.id!=null&&(c.id=i.id),ai(c,i.class),i.title){let _=bi(ax,c);_.textContent=i.title}let h=Pi("canvas"),u=n.ctx=h.getContext("2d"),d=bi(lx,c);pr("click",d,_=>{_.target===g&&(Gt!=Ur||Yt!=Fr)&&Ln.click(n,_)},!0);let f=n.under=bi(cx,d);d.appendChild(h);let g=n.over=bi(hx,d);i=Zr(i);let v=+wt(i.pxAlign,1),m=Lm(v);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let p=i.ms||.001,x=n.series=s==1?Um(i.series||[],Em,Pm,!1):X_(i.series||[null],Rm),M=n.axes=Um(i.axes||[],wm,Am,!0),b=n.scales={},C=n.bands=i.bands||[];C.forEach(_=>{_.fill=gt(_.fill||null),_.dir=wt(_.dir,-1)});let E=s==2?x[1].facets[0].scale:x[0].scale,y={axes:fs,series:ft},S=(i.drawOrder||["axes","series"]).map(_=>y[_]);function U(_){let T=_.distr==3?N=>ms(N>0?N:_.clamp(n,N,_.min,_.max,_.key)):_.distr==4?N=>Au(N,_.asinh):_.distr==100?N=>_.fwd(N):N=>N;return N=>{let D=T(N),{_min:X,_max:K}=_,le=K-X;return(D-X)/le}}function L(_){let T=b[_];if(T==null){let N=(i.scales||ua)[_]||ua;if(N.from!=null){L(N.from);let D=mn({},b[N.from],N,{key:_});D.valToPct=U(D),b[_]=D}else{T=b[_]=mn({},_==E?hg:N_,N),T.key=_;let D=T.time,X=T.range,K=Bs(X);if((_!=E||s==2&&!D)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?hm:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?hm:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&Sl(X))){let le=X;X=(fe,_e,Ne)=>_e==null?Jr:yl(_e,Ne,le)}T.range=gt(X||(D?q_:_==E?T.distr==3?Y_:T.distr==4?J_:_g:T.distr==3?bg:T.distr==4?Mg:$_)),T.auto=gt(K?!1:T.auto),T.clamp=gt(T.clamp||L_),T._min=T._max=null,T.valToPct=U(T)}}}L("x"),L("y"),s==1&&x.forEach(_=>{L(_.scale)}),M.forEach(_=>{L(_.scale)});for(let _ in i.scales)L(_);let R=b[E],O=R.distr,V,P;R.ori==0?(ai(c,rx),V=r,P=o):(ai(c,ox),V=o,P=r);let H={};for(let _ in b){let T=b[_];(T.min!=null||T.max!=null)&&(H[_]={min:T.min,max:T.max},T.min=T.max=null)}let Y=i.tzDate||(_=>new Date(xn(_/p))),k=i.fmtDate||Yu,re=p==1?r_(Y):l_(Y),q=bm(Y,_m(p==1?s_:a_,k)),j=Sm(Y,Mm(h_,k)),te=[],de=n.legend=mn({},f_,i.legend),ue=n.cursor=mn({},x_,{drag:{y:s==2}},i.cursor),ee=de.show,me=ue.show,ye=de.markers;de.idxs=te,ye.width=gt(ye.width),ye.dash=gt(ye.dash),ye.stroke=gt(ye.stroke),ye.fill=gt(ye.fill);let Ae,Me,Xe,rt=[],Ge=[],ut,lt=!1,it={};if(de.live){let _=x[1]?x[1].values:null;lt=_!=null,ut=lt?_(n,1,0):{_:0};for(let T in ut)it[T]=Gu}if(ee)if(Ae=Pi("table",gx,c),Xe=Pi("tbody",null,Ae),de.mount(n,Ae),lt){Me=Pi("thead",null,Ae,Xe);let _=Pi("tr",null,Me);Pi("th",null,_);for(var $t in ut)Pi("th",Kp,_).textContent=$t}else ai(Ae,yx),de.live&&ai(Ae,vx);let Bt={show:!0},cn={show:!1};function Nt(_,T){if(T==0&&(lt||!de.live||s==2))return Jr;let N=[],D=Pi("tr",xx,Xe,Xe.childNodes[T]);ai(D,_.class),_.show||ai(D,fr);let X=Pi("th",null,D);if(ye.show){let fe=bi(_x,X);if(T>0){let _e=ye.width(n,T);_e&&(fe.style.border=_e+"px "+ye.dash(n,T)+" "+ye.stroke(n,T)),fe.style.background=ye.fill(n,T)}}let K=bi(Kp,X);_.label instanceof HTMLElement?K.appendChild(_.label):K.textContent=_.label,T>0&&(ye.show||(K.style.color=_.width>0?ye.stroke(n,T):ye.fill(n,T)),bt("click",X,fe=>{if(ue._lock)return;je(fe);let _e=x.indexOf(_);if((fe.ctrlKey||fe.metaKey)!=de.isolate){let Ne=x.some((De,Oe)=>Oe>0&&Oe!=_e&&De.show);x.forEach((De,Oe)=>{Oe>0&&qi(Oe,Ne?Oe==_e?Bt:cn:Bt,!0,pn.setSeries)})}else qi(_e,{show:!_.show},!0,pn.setSeries)},!1),Qe&&bt(tm,X,fe=>{ue._lock||(je(fe),qi(x.indexOf(_),kr,!0,pn.setSeries))},!1));for(var le in ut){let fe=Pi("td",bx,D);fe.textContent="--",N.push(fe)}return[D,N]}let Sn=new Map;function bt(_,T,N,D=!0){let X=Sn.get(T)||{},K=ue.bind[_](n,T,N,D);K&&(pr(_,T,X[_]=K),Sn.set(T,X))}function vn(_,T,N){let D=Sn.get(T)||{};for(let X in D)(_==null||X==_)&&(Du(X,T,D[X]),delete D[X]);_==null&&Sn.delete(T)}let Qt=0,hn=0,z=0,Re=0,Je=0,ot=0,Se=Je,Ft=ot,Ve=z,$e=Re,I=0,w=0,$=0,he=0;n.bbox={};let ae=!1,ve=!1,xe=!1,ne=!1,se=!1,pe=!1;function B(_,T,N){(N||_!=n.width||T!=n.height)&&oe(_,T),ct(!1),xe=!0,ve=!0,On()}function oe(_,T){n.width=Qt=z=_,n.height=hn=Re=T,Je=ot=0,be(),He();let N=n.bbox;I=N.left=ur(Je*Tt,.5),w=N.top=ur(ot*Tt,.5),$=N.width=ur(z*Tt,.5),he=N.height=ur(Re*Tt,.5)}let ie=3;function we(){let _=!1,T=0;for(;!_;){T++;let N=Lr(T),D=Xi(T);_=T==ie||N&&D,_||(oe(n.width,n.height),ve=!0)}}function ge({width:_,height:T}){B(_,T)}n.setSize=ge;function be(){let _=!1,T=!1,N=!1,D=!1;M.forEach((X,K)=>{if(X.show&&X._show){let{side:le,_size:fe}=X,_e=le%2,Ne=X.label!=null?X.labelSize:0,De=fe+Ne;De>0&&(_e?(z-=De,le==3?(Je+=De,D=!0):N=!0):(Re-=De,le==0?(ot+=De,_=!0):T=!0))}}),Hi[0]=_,Hi[1]=N,Hi[2]=T,Hi[3]=D,z-=Ti[1]+Ti[3],Je+=Ti[3],Re-=Ti[2]+Ti[0],ot+=Ti[0]}function He(){let _=Je+z,T=ot+Re,N=Je,D=ot;function X(K,le){switch(K){case 1:return _+=le,_-le;case 2:return T+=le,T-le;case 3:return N-=le,N+le;case 0:return D-=le,D+le}}M.forEach((K,le)=>{if(K.show&&K._show){let fe=K.side;K._pos=X(fe,K._size),K.label!=null&&(K._lpos=X(fe,K.labelSize))}})}if(ue.dataIdx==null){let _=ue.hover,T=_.skip=new Set(_.skip??[]);T.add(void 0);let N=_.prox=gt(_.prox),D=_.bias??=0;ue.dataIdx=(X,K,le,fe)=>{if(K==0)return le;let _e=le,Ne=N(X,K,le,fe)??Ot,De=Ne>=0&&Ne<Ot,Oe=R.ori==0?z:Re,st=ue.left,Et=e[0],Mt=e[K];if(T.has(Mt[le])){_e=null;let pt=null,Ke=null,qe;if(D==0||D==-1)for(qe=le;pt==null&&qe-- >0;)T.has(Mt[qe])||(pt=qe);if(D==0||D==1)for(qe=le;Ke==null&&qe++<Mt.length;)T.has(Mt[qe])||(Ke=qe);if(pt!=null||Ke!=null)if(De){let Wt=pt==null?-1/0:V(Et[pt],R,Oe,0),nn=Ke==null?1/0:V(Et[Ke],R,Oe,0),An=st-Wt,Dt=nn-st;An<=Dt?An<=Ne&&(_e=pt):Dt<=Ne&&(_e=Ke)}else _e=Ke==null?pt:pt==null?Ke:le-pt<=Ke-le?pt:Ke}else De&&_n(st-V(Et[le],R,Oe,0))>Ne&&(_e=null);return _e}}let je=_=>{ue.event=_};ue.idxs=te,ue._lock=!1;let ce=ue.points;ce.show=gt(ce.show),ce.size=gt(ce.size),ce.stroke=gt(ce.stroke),ce.width=gt(ce.width),ce.fill=gt(ce.fill);let ke=n.focus=mn({},i.focus||{alpha:.3},ue.focus),Qe=ke.prox>=0,Ce=Qe&&ce.one,at=[],Vt=[],Hn=[];function Yo(_,T){let N=ce.show(n,T);if(N instanceof HTMLElement)return ai(N,mx),ai(N,_.class),ns(N,-10,-10,z,Re),g.insertBefore(N,at[T]),N}function Rr(_,T){if(s==1||T>0){let N=s==1&&b[_.scale].time,D=_.value;_.value=N?gm(D)?Sm(Y,Mm(D,k)):D||j:D||R_,_.label=_.label||(N?b_:__)}if(Ce||T>0){_.width=_.width==null?1:_.width,_.paths=_.paths||H_||Nx,_.fillTo=gt(_.fillTo||D_),_.pxAlign=+wt(_.pxAlign,v),_.pxRound=Lm(_.pxAlign),_.stroke=gt(_.stroke||null),_.fill=gt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let N=P_(Jn(1,_.width),1),D=_.points=mn({},{size:N,width:Jn(1,N*.2),stroke:_.stroke,space:N*2,paths:W_,_stroke:null,_fill:null},_.points);D.show=gt(D.show),D.filter=gt(D.filter),D.fill=gt(D.fill),D.stroke=gt(D.stroke),D.paths=gt(D.paths),D.pxAlign=_.pxAlign}if(ee){let N=Nt(_,T);rt.splice(T,0,N[0]),Ge.splice(T,0,N[1]),de.values.push(null)}if(me){te.splice(T,0,null);let N=null;Ce?T==0&&(N=Yo(_,T)):T>0&&(N=Yo(_,T)),at.splice(T,0,N),Vt.splice(T,0,0),Hn.splice(T,0,0)}Tn("addSeries",T)}function eu(_,T){T=T??x.length,_=s==1?zu(_,T,Em,Pm):zu(_,T,{},Rm),x.splice(T,0,_),Rr(x[T],T)}n.addSeries=eu;function Ka(_){if(x.splice(_,1),ee){de.values.splice(_,1),Ge.splice(_,1);let T=rt.splice(_,1)[0];vn(null,T.firstChild),T.remove()}me&&(te.splice(_,1),at.splice(_,1)[0].remove(),Vt.splice(_,1),Hn.splice(_,1)),Tn("delSeries",_)}n.delSeries=Ka;let Hi=[!1,!1,!1,!1];function hs(_,T){if(_._show=_.show,_.show){let N=_.side%2,D=b[_.scale];D==null&&(_.scale=N?x[1].scale:E,D=b[_.scale]);let X=D.time;_.size=gt(_.size),_.space=gt(_.space),_.rotate=gt(_.rotate),Bs(_.incrs)&&_.incrs.forEach(le=>{!zs.has(le)&&zs.set(le,Xm(le))}),_.incrs=gt(_.incrs||(D.distr==2?t_:X?p==1?i_:o_:dr)),_.splits=gt(_.splits||(X&&D.distr==1?re:D.distr==3?Fu:D.distr==4?w_:S_)),_.stroke=gt(_.stroke),_.grid.stroke=gt(_.grid.stroke),_.ticks.stroke=gt(_.ticks.stroke),_.border.stroke=gt(_.border.stroke);let K=_.values;_.values=Bs(K)&&!Bs(K[0])?gt(K):X?Bs(K)?bm(Y,_m(K,k)):gm(K)?c_(Y,K):K||q:K||M_,_.filter=gt(_.filter||(D.distr>=3&&D.log==10?A_:D.distr==3&&D.log==2?C_:Hm)),_.font=Fm(_.font),_.labelFont=Fm(_.labelFont),_._size=_.size(n,null,T,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Hi[T]=!0,_._el=bi(ux,d))}}function us(_,T,N,D){let[X,K,le,fe]=N,_e=T%2,Ne=0;return _e==0&&(fe||K)&&(Ne=T==0&&!X||T==2&&!le?xn(wm.size/3):0),_e==1&&(X||le)&&(Ne=T==1&&!K||T==3&&!fe?xn(Am.size/2):0),Ne}let Jo=n.padding=(i.padding||[us,us,us,us]).map(_=>gt(wt(_,us))),Ti=n._padding=Jo.map((_,T)=>_(n,T,Hi,0)),en,rn=null,on=null,Wi=s==1?x[0].idxs:null,ni=null,Rs=!1;function Zo(_,T){if(e=_??[],n.data=n._data=e,s==2){en=0;for(let N=1;N<x.length;N++)en+=e[N][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ni=e[0],en=ni.length;let N=e;if(O==2){N=e.slice();let D=N[0]=Array(en);for(let X=0;X<en;X++)D[X]=X}n._data=e=N}if(ct(!0),Tn("setData"),O==2&&(xe=!0),T!==!1){let N=R;N.auto(n,Rs)?Ko():Ls(E,N.min,N.max),ne=ne||ue.left>=0,pe=!0,On()}}n.setData=Zo;function Ko(){Rs=!0;let _,T;s==1&&(en>0?(rn=Wi[0]=0,on=Wi[1]=en-1,_=e[0][rn],T=e[0][on],O==2?(_=rn,T=on):_==T&&(O==3?[_,T]=bl(_,_,R.log,!1):O==4?[_,T]=Wu(_,_,R.log,!1):R.time?T=_+xn(86400/p):[_,T]=yl(_,T,Xu,!0))):(rn=Wi[0]=_=null,on=Wi[1]=T=null)),Ls(E,_,T)}let Pr,Ps,Ir,A,G,Q,J,Z,Ee,Pe;function Te(_,T,N,D,X,K){_??=Qp,N??=$u,D??="butt",X??=Qp,K??="round",_!=Pr&&(u.strokeStyle=Pr=_),X!=Ps&&(u.fillStyle=Ps=X),T!=Ir&&(u.lineWidth=Ir=T),K!=G&&(u.lineJoin=G=K),D!=Q&&(u.lineCap=Q=D),N!=A&&u.setLineDash(A=N)}function Ie(_,T,N,D){T!=Ps&&(u.fillStyle=Ps=T),_!=J&&(u.font=J=_),N!=Z&&(u.textAlign=Z=N),D!=Ee&&(u.textBaseline=Ee=D)}function ze(_,T,N,D,X=0){if(D.length>0&&_.auto(n,Rs)&&(T==null||T.min==null)){let K=wt(rn,0),le=wt(on,D.length-1),fe=N.min==null?Ax(D,K,le,X,_.distr==3):[N.min,N.max];_.min=Li(_.min,N.min=fe[0]),_.max=Jn(_.max,N.max=fe[1])}}let et={min:null,max:null};function dt(){for(let D in b){let X=b[D];H[D]==null&&(X.min==null||H[E]!=null&&X.auto(n,Rs))&&(H[D]=et)}for(let D in b){let X=b[D];H[D]==null&&X.from!=null&&H[X.from]!=null&&(H[D]=et)}H[E]!=null&&ct(!0);let _={};for(let D in H){let X=H[D];if(X!=null){let K=_[D]=Zr(b[D],Fx);if(X.min!=null)mn(K,X);else if(D!=E||s==2)if(en==0&&K.from==null){let le=K.range(n,null,null,D);K.min=le[0],K.max=le[1]}else K.min=Ot,K.max=-Ot}}if(en>0){x.forEach((D,X)=>{if(s==1){let K=D.scale,le=H[K];if(le==null)return;let fe=_[K];if(X==0){let _e=fe.range(n,fe.min,fe.max,K);fe.min=_e[0],fe.max=_e[1],rn=Ii(fe.min,e[0]),on=Ii(fe.max,e[0]),on-rn>1&&(e[0][rn]<fe.min&&rn++,e[0][on]>fe.max&&on--),D.min=ni[rn],D.max=ni[on]}else D.show&&D.auto&&ze(fe,le,D,e[X],D.sorted);D.idxs[0]=rn,D.idxs[1]=on}else if(X>0&&D.show&&D.auto){let[K,le]=D.facets,fe=K.scale,_e=le.scale,[Ne,De]=e[X],Oe=_[fe],st=_[_e];Oe!=null&&ze(Oe,H[fe],K,Ne,K.sorted),st!=null&&ze(st,H[_e],le,De,le.sorted),D.min=le.min,D.max=le.max}});for(let D in _){let X=_[D],K=H[D];if(X.from==null&&(K==null||K.min==null)){let le=X.range(n,X.min==Ot?null:X.min,X.max==-Ot?null:X.max,D);X.min=le[0],X.max=le[1]}}}for(let D in _){let X=_[D];if(X.from!=null){let K=_[X.from];if(K.min==null)X.min=X.max=null;else{let le=X.range(n,K.min,K.max,D);X.min=le[0],X.max=le[1]}}}let T={},N=!1;for(let D in _){let X=_[D],K=b[D];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let le=K.distr;K._min=le==3?ms(K.min):le==4?Au(K.min,K.asinh):le==100?K.fwd(K.min):K.min,K._max=le==3?ms(K.max):le==4?Au(K.max,K.asinh):le==100?K.fwd(K.max):K.max,T[D]=N=!0}}if(N){x.forEach((D,X)=>{s==2?X>0&&T.y&&(D._paths=null):T[D.scale]&&(D._paths=null)});for(let D in T)xe=!0,Tn("setScale",D);me&&ue.left>=0&&(ne=pe=!0)}for(let D in H)H[D]=null}function Be(_){let T=Uu(rn-1,0,en-1),N=Uu(on+1,0,en-1);for(;_[T]==null&&T>0;)T--;for(;_[N]==null&&N<en-1;)N++;return[T,N]}function ft(){if(en>0){let _=x.some(T=>T._focus)&&Pe!=ke.alpha;_&&(u.globalAlpha=Pe=ke.alpha),x.forEach((T,N)=>{if(N>0&&T.show&&(Zt(N,!1),Zt(N,!0),T._paths==null)){let D=Pe;Pe!=T.alpha&&(u.globalAlpha=Pe=T.alpha);let X=s==2?[0,e[N][0].length-1]:Be(e[N]);T._paths=T.paths(n,N,X[0],X[1]),Pe!=D&&(u.globalAlpha=Pe=D)}}),x.forEach((T,N)=>{if(N>0&&T.show){let D=Pe;Pe!=T.alpha&&(u.globalAlpha=Pe=T.alpha),T._paths!=null&&Pt(N,!1);{let X=T._paths!=null?T._paths.gaps:null,K=T.points.show(n,N,rn,on,X),le=T.points.filter(n,N,K,X);(K||le)&&(T.points._paths=T.points.paths(n,N,rn,on,le),Pt(N,!0))}Pe!=D&&(u.globalAlpha=Pe=D),Tn("drawSeries",N)}}),_&&(u.globalAlpha=Pe=1)}}function Zt(_,T){let N=T?x[_].points:x[_];N._stroke=N.stroke(n,_),N._fill=N.fill(n,_)}function Pt(_,T){let N=T?x[_].points:x[_],{stroke:D,fill:X,clip:K,flags:le,_stroke:fe=N._stroke,_fill:_e=N._fill,_width:Ne=N.width}=N._paths;Ne=kt(Ne*Tt,3);let De=null,Oe=Ne%2/2;T&&_e==null&&(_e=Ne>0?"#fff":fe);let st=N.pxAlign==1&&Oe>0;if(st&&u.translate(Oe,Oe),!T){let Et=I-Ne/2,Mt=w-Ne/2,pt=$+Ne,Ke=he+Ne;De=new Path2D,De.rect(Et,Mt,pt,Ke)}T?Ue(fe,Ne,N.dash,N.cap,_e,D,X,le,K):It(_,fe,Ne,N.dash,N.cap,_e,D,X,le,De,K),st&&u.translate(-Oe,-Oe)}function It(_,T,N,D,X,K,le,fe,_e,Ne,De){let Oe=!1;_e!=0&&C.forEach((st,Et)=>{if(st.series[0]==_){let Mt=x[st.series[1]],pt=e[st.series[1]],Ke=(Mt._paths||ua).band;Bs(Ke)&&(Ke=st.dir==1?Ke[0]:Ke[1]);let qe,Wt=null;Mt.show&&Ke&&Rx(pt,rn,on)?(Wt=st.fill(n,Et)||K,qe=Mt._paths.clip):Ke=null,Ue(T,N,D,X,Wt,le,fe,_e,Ne,De,qe,Ke),Oe=!0}}),Oe||Ue(T,N,D,X,K,le,fe,_e,Ne,De)}let yn=Kr|ku;function Ue(_,T,N,D,X,K,le,fe,_e,Ne,De,Oe){Te(_,T,N,D,X),(_e||Ne||Oe)&&(u.save(),_e&&u.clip(_e),Ne&&u.clip(Ne)),Oe?(fe&yn)==yn?(u.clip(Oe),De&&u.clip(De),mt(X,le),un(_,K,T)):fe&ku?(mt(X,le),u.clip(Oe),un(_,K,T)):fe&Kr&&(u.save(),u.clip(Oe),De&&u.clip(De),mt(X,le),u.restore(),un(_,K,T)):(mt(X,le),un(_,K,T)),(_e||Ne||Oe)&&u.restore()}function un(_,T,N){N>0&&(T instanceof Map?T.forEach((D,X)=>{u.strokeStyle=Pr=X,u.stroke(D)}):T!=null&&_&&u.stroke(T))}function mt(_,T){T instanceof Map?T.forEach((N,D)=>{u.fillStyle=Ps=D,u.fill(N)}):T!=null&&_&&u.fill(T)}function ds(_,T,N,D){let X=M[_],K;if(D<=0)K=[0,0];else{let le=X._space=X.space(n,_,T,N,D),fe=X._incrs=X.incrs(n,_,T,N,D,le);K=Z_(T,N,fe,D,le)}return X._found=K}function dn(_,T,N,D,X,K,le,fe,_e,Ne){let De=le%2/2;v==1&&u.translate(De,De),Te(fe,le,_e,Ne,fe),u.beginPath();let Oe,st,Et,Mt,pt=X+(D==0||D==3?-K:K);N==0?(st=X,Mt=pt):(Oe=X,Et=pt);for(let Ke=0;Ke<_.length;Ke++)T[Ke]!=null&&(N==0?Oe=Et=_[Ke]:st=Mt=_[Ke],u.moveTo(Oe,st),u.lineTo(Et,Mt));u.stroke(),v==1&&u.translate(-De,-De)}function Lr(_){let T=!0;return M.forEach((N,D)=>{if(!N.show)return;let X=b[N.scale];if(X.min==null){N._show&&(T=!1,N._show=!1,ct(!1));return}else N._show||(T=!1,N._show=!0,ct(!1));let K=N.side,le=K%2,{min:fe,max:_e}=X,[Ne,De]=ds(D,fe,_e,le==0?z:Re);if(De==0)return;let Oe=X.distr==2,st=N._splits=N.splits(n,D,fe,_e,Ne,De,Oe),Et=X.distr==2?st.map(qe=>ni[qe]):st,Mt=X.distr==2?ni[st[1]]-ni[st[0]]:Ne,pt=N._values=N.values(n,N.filter(n,Et,D,De,Mt),D,De,Mt);N._rotate=K==2?N.rotate(n,pt,D,De):0;let Ke=N._size;N._size=Mi(N.size(n,pt,D,_)),Ke!=null&&N._size!=Ke&&(T=!1)}),T}function Xi(_){let T=!0;return Jo.forEach((N,D)=>{let X=N(n,D,Hi,_);X!=Ti[D]&&(T=!1),Ti[D]=X}),T}function fs(){for(let _=0;_<M.length;_++){let T=M[_];if(!T.show||!T._show)continue;let N=T.side,D=N%2,X,K,le=T.stroke(n,_),fe=N==0||N==3?-1:1,[_e,Ne]=T._found;if(T.label!=null){let qn=T.labelGap*fe,ri=xn((T._lpos+qn)*Tt);Ie(T.labelFont[0],le,"center",N==2?"top":jp),u.save(),D==1?(X=K=0,u.translate(ri,xn(w+he/2)),u.rotate((N==3?-gl:gl)/2)):(X=xn(I+$/2),K=ri);let or=Vm(T.label)?T.label(n,_,_e,Ne):T.label;u.fillText(or,X,K),u.restore()}if(Ne==0)continue;let De=b[T.scale],Oe=D==0?$:he,st=D==0?I:w,Et=T._splits,Mt=De.distr==2?Et.map(qn=>ni[qn]):Et,pt=De.distr==2?ni[Et[1]]-ni[Et[0]]:_e,Ke=T.ticks,qe=T.border,Wt=Ke.show?Ke.size:0,nn=xn(Wt*Tt),An=xn((T.alignTo==2?T._size-Wt-T.gap:T.gap)*Tt),Dt=T._rotate*-gl/180,sn=m(T._pos*Tt),ii=(nn+An)*fe,Xn=sn+ii;K=D==0?Xn:0,X=D==1?Xn:0;let vi=T.font[0],Ai=T.align==1?Xr:T.align==2?wu:Dt>0?Xr:Dt<0?wu:D==0?"center":N==3?wu:Xr,Yi=Dt||D==1?"middle":N==2?"top":jp;Ie(vi,le,Ai,Yi);let si=T.font[1]*T.lineGap,yi=Et.map(qn=>m(a(qn,De,Oe,st))),Ci=T._values;for(let qn=0;qn<Ci.length;qn++){let ri=Ci[qn];if(ri!=null){D==0?X=yi[qn]:K=yi[qn],ri=""+ri;let or=ri.indexOf(`
`)==-1?[ri]:ri.split(/\n/gm);for(let $n=0;$n<or.length;$n++){let hp=or[$n];Dt?(u.save(),u.translate(X,K+$n*si),u.rotate(Dt),u.fillText(hp,0,0),u.restore()):u.fillText(hp,X,K+$n*si)}}}Ke.show&&dn(yi,Ke.filter(n,Mt,_,Ne,pt),D,N,sn,nn,kt(Ke.width*Tt,3),Ke.stroke(n,_),Ke.dash,Ke.cap);let Ji=T.grid;Ji.show&&dn(yi,Ji.filter(n,Mt,_,Ne,pt),D,D==0?2:1,D==0?w:I,D==0?he:$,kt(Ji.width*Tt,3),Ji.stroke(n,_),Ji.dash,Ji.cap),qe.show&&dn([sn],[1],D==0?1:0,D==0?1:2,D==1?w:I,D==1?he:$,kt(qe.width*Tt,3),qe.stroke(n,_),qe.dash,qe.cap)}Tn("drawAxes")}function ct(_){x.forEach((T,N)=>{N>0&&(T._paths=null,_&&(s==1?(T.min=null,T.max=null):T.facets.forEach(D=>{D.min=null,D.max=null})))})}let tn=!1,Wn=!1,Lt=[];function fn(){Wn=!1;for(let _=0;_<Lt.length;_++)Tn(...Lt[_]);Lt.length=0}function On(){tn||(Hx(qf),tn=!0)}function ja(_,T=!1){tn=!0,Wn=T,_(n),qf(),T&&Lt.length>0&&queueMicrotask(fn)}n.batch=ja;function qf(){if(ae&&(dt(),ae=!1),xe&&(we(),xe=!1),ve){if(Xt(f,Xr,Je),Xt(f,"top",ot),Xt(f,aa,z),Xt(f,la,Re),Xt(g,Xr,Je),Xt(g,"top",ot),Xt(g,aa,z),Xt(g,la,Re),Xt(d,aa,Qt),Xt(d,la,hn),h.width=xn(Qt*Tt),h.height=xn(hn*Tt),M.forEach(({_el:_,_show:T,_size:N,_pos:D,side:X})=>{if(_!=null)if(T){let K=X===3||X===0?N:0,le=X%2==1;Xt(_,le?"left":"top",D-K),Xt(_,le?"width":"height",N),Xt(_,le?"top":"left",le?ot:Je),Xt(_,le?"height":"width",le?Re:z),Nu(_,fr)}else ai(_,fr)}),Pr=Ps=Ir=G=Q=J=Z=Ee=A=null,Pe=1,ea(!0),Je!=Se||ot!=Ft||z!=Ve||Re!=$e){ct(!1);let _=z/Ve,T=Re/$e;if(me&&!ne&&ue.left>=0){ue.left*=_,ue.top*=T,Nr&&ns(Nr,xn(ue.left),0,z,Re),Dr&&ns(Dr,0,xn(ue.top),z,Re);for(let N=0;N<at.length;N++){let D=at[N];D!=null&&(Vt[N]*=_,Hn[N]*=T,ns(D,Mi(Vt[N]),Mi(Hn[N]),z,Re))}}if(Ht.show&&!se&&Ht.left>=0&&Ht.width>0){Ht.left*=_,Ht.width*=_,Ht.top*=T,Ht.height*=T;for(let N in ou)Xt(Or,N,Ht[N])}Se=Je,Ft=ot,Ve=z,$e=Re}Tn("setSize"),ve=!1}Qt>0&&hn>0&&(u.clearRect(0,0,h.width,h.height),Tn("drawClear"),S.forEach(_=>_()),Tn("draw")),Ht.show&&se&&(Qa(Ht),se=!1),me&&ne&&(rr(null,!0,!1),ne=!1),de.show&&de.live&&pe&&(su(),pe=!1),l||(l=!0,n.status=1,Tn("ready")),Rs=!1,tn=!1}n.redraw=(_,T)=>{xe=T||!1,_!==!1?Ls(E,R.min,R.max):On()};function tu(_,T){let N=b[_];if(N.from==null){if(en==0){let D=N.range(n,T.min,T.max,_);T.min=D[0],T.max=D[1]}if(T.min>T.max){let D=T.min;T.min=T.max,T.max=D}if(en>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;_==E&&N.distr==2&&en>0&&(T.min=Ii(T.min,e[0]),T.max=Ii(T.max,e[0]),T.min==T.max&&T.max++),H[_]=T,ae=!0,On()}}n.setScale=tu;let nu,iu,Nr,Dr,$f,Yf,Ur,Fr,Jf,Zf,Gt,Yt,Is=!1,Ln=ue.drag,wn=Ln.x,En=Ln.y;me&&(ue.x&&(nu=bi(fx,g)),ue.y&&(iu=bi(px,g)),R.ori==0?(Nr=nu,Dr=iu):(Nr=iu,Dr=nu),Gt=ue.left,Yt=ue.top);let Ht=n.select=mn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Or=Ht.show?bi(dx,Ht.over?g:f):null;function Qa(_,T){if(Ht.show){for(let N in _)Ht[N]=_[N],N in ou&&Xt(Or,N,_[N]);T!==!1&&Tn("setSelect")}}n.setSelect=Qa;function ly(_){if(x[_].show)ee&&Nu(rt[_],fr);else if(ee&&ai(rt[_],fr),me){let N=Ce?at[0]:at[_];N!=null&&ns(N,-10,-10,z,Re)}}function Ls(_,T,N){tu(_,{min:T,max:N})}function qi(_,T,N,D){T.focus!=null&&fy(_),T.show!=null&&x.forEach((X,K)=>{K>0&&(_==K||_==null)&&(X.show=T.show,ly(K),s==2?(Ls(X.facets[0].scale,null,null),Ls(X.facets[1].scale,null,null)):Ls(X.scale,null,null),On())}),N!==!1&&Tn("setSeries",_,T),D&&ta("setSeries",n,_,T)}n.setSeries=qi;function cy(_,T){mn(C[_],T)}function hy(_,T){_.fill=gt(_.fill||null),_.dir=wt(_.dir,-1),T=T??C.length,C.splice(T,0,_)}function uy(_){_==null?C.length=0:C.splice(_,1)}n.addBand=hy,n.setBand=cy,n.delBand=uy;function dy(_,T){x[_].alpha=T,me&&at[_]!=null&&(at[_].style.opacity=T),ee&&rt[_]&&(rt[_].style.opacity=T)}let ps,Ns,sr,kr={focus:!0};function fy(_){if(_!=sr){let T=_==null,N=ke.alpha!=1;x.forEach((D,X)=>{if(s==1||X>0){let K=T||X==0||X==_;D._focus=T?null:K,N&&dy(X,K?1:ke.alpha)}}),sr=_,N&&On()}}ee&&Qe&&bt(nm,Ae,_=>{ue._lock||(je(_),sr!=null&&qi(null,kr,!0,pn.setSeries))});function $i(_,T,N){let D=b[T];N&&(_=_/Tt-(D.ori==1?ot:Je));let X=z;D.ori==1&&(X=Re,_=X-_),D.dir==-1&&(_=X-_);let K=D._min,le=D._max,fe=_/X,_e=K+(le-K)*fe,Ne=D.distr;return Ne==3?Yr(10,_e):Ne==4?Ix(_e,D.asinh):Ne==100?D.bwd(_e):_e}function py(_,T){let N=$i(_,E,T);return Ii(N,e[0],rn,on)}n.valToIdx=_=>Ii(_,e[0]),n.posToIdx=py,n.posToVal=$i,n.valToPos=(_,T,N)=>b[T].ori==0?r(_,b[T],N?$:z,N?I:0):o(_,b[T],N?he:Re,N?w:0),n.setCursor=(_,T,N)=>{Gt=_.left,Yt=_.top,rr(null,T,N)};function Kf(_,T){Xt(Or,Xr,Ht.left=_),Xt(Or,aa,Ht.width=T)}function jf(_,T){Xt(Or,"top",Ht.top=_),Xt(Or,la,Ht.height=T)}let jo=R.ori==0?Kf:jf,Qo=R.ori==1?Kf:jf;function my(){if(ee&&de.live)for(let _=s==2?1:0;_<x.length;_++){if(_==0&&lt)continue;let T=de.values[_],N=0;for(let D in T)Ge[_][N++].firstChild.nodeValue=T[D]}}function su(_,T){if(_!=null&&(_.idxs?_.idxs.forEach((N,D)=>{te[D]=N}):Ux(_.idx)||te.fill(_.idx),de.idx=te[0]),ee&&de.live){for(let N=0;N<x.length;N++)(N>0||s==1&&!lt)&&gy(N,te[N]);my()}pe=!1,T!==!1&&Tn("setLegend")}n.setLegend=su;function gy(_,T){let N=x[_],D=_==0&&O==2?ni:e[_],X;lt?X=N.values(n,_,T)??it:(X=N.value(n,T==null?null:D[T],_,T),X=X==null?it:{_:X}),de.values[_]=X}function rr(_,T,N){Jf=Gt,Zf=Yt,[Gt,Yt]=ue.move(n,Gt,Yt),ue.left=Gt,ue.top=Yt,me&&(Nr&&ns(Nr,xn(Gt),0,z,Re),Dr&&ns(Dr,0,xn(Yt),z,Re));let D,X=rn>on;ps=Ot,Ns=null;let K=R.ori==0?z:Re,le=R.ori==1?z:Re;if(Gt<0||en==0||X){D=ue.idx=null;for(let fe=0;fe<x.length;fe++){let _e=at[fe];_e!=null&&ns(_e,-10,-10,z,Re)}Qe&&qi(null,kr,!0,_==null&&pn.setSeries),de.live&&(te.fill(D),pe=!0)}else{let fe,_e,Ne;s==1&&(fe=R.ori==0?Gt:Yt,_e=$i(fe,E),D=ue.idx=Ii(_e,e[0],rn,on),Ne=V(e[0][D],R,K,0));let De=-10,Oe=-10,st=0,Et=0,Mt=!0,pt="",Ke="";for(let qe=s==2?1:0;qe<x.length;qe++){let Wt=x[qe],nn=te[qe],An=nn==null?null:s==1?e[qe][nn]:e[qe][1][nn],Dt=ue.dataIdx(n,qe,D,_e),sn=Dt==null?null:s==1?e[qe][Dt]:e[qe][1][Dt];if(pe=pe||sn!=An||Dt!=nn,te[qe]=Dt,qe>0&&Wt.show){let ii=Dt==null?-10:Dt==D?Ne:V(s==1?e[0][Dt]:e[qe][0][Dt],R,K,0),Xn=sn==null?-10:P(sn,s==1?b[Wt.scale]:b[Wt.facets[1].scale],le,0);if(Qe&&sn!=null){let vi=R.ori==1?Gt:Yt,Ai=_n(ke.dist(n,qe,Dt,Xn,vi));if(Ai<ps){let Yi=ke.bias;if(Yi!=0){let si=$i(vi,Wt.scale),yi=sn>=0?1:-1,Ci=si>=0?1:-1;Ci==yi&&(Ci==1?Yi==1?sn>=si:sn<=si:Yi==1?sn<=si:sn>=si)&&(ps=Ai,Ns=qe)}else ps=Ai,Ns=qe}}if(pe||Ce){let vi,Ai;R.ori==0?(vi=ii,Ai=Xn):(vi=Xn,Ai=ii);let Yi,si,yi,Ci,Ji,qn,ri=!0,or=ce.bbox;if(or!=null){ri=!1;let $n=or(n,qe);yi=$n.left,Ci=$n.top,Yi=$n.width,si=$n.height}else yi=vi,Ci=Ai,Yi=si=ce.size(n,qe);if(qn=ce.fill(n,qe),Ji=ce.stroke(n,qe),Ce)qe==Ns&&ps<=ke.prox&&(De=yi,Oe=Ci,st=Yi,Et=si,Mt=ri,pt=qn,Ke=Ji);else{let $n=at[qe];$n!=null&&(Vt[qe]=yi,Hn[qe]=Ci,cm($n,Yi,si,ri),am($n,qn,Ji),ns($n,Mi(yi),Mi(Ci),z,Re))}}}}if(Ce){let qe=ke.prox,Wt=sr==null?ps<=qe:ps>qe||Ns!=sr;if(pe||Wt){let nn=at[0];nn!=null&&(Vt[0]=De,Hn[0]=Oe,cm(nn,st,Et,Mt),am(nn,pt,Ke),ns(nn,Mi(De),Mi(Oe),z,Re))}}}if(Ht.show&&Is)if(_!=null){let[fe,_e]=pn.scales,[Ne,De]=pn.match,[Oe,st]=_.cursor.sync.scales,Et=_.cursor.drag;if(wn=Et._x,En=Et._y,wn||En){let{left:Mt,top:pt,width:Ke,height:qe}=_.select,Wt=_.scales[Oe].ori,nn=_.posToVal,An,Dt,sn,ii,Xn,vi=fe!=null&&Ne(fe,Oe),Ai=_e!=null&&De(_e,st);vi&&wn?(Wt==0?(An=Mt,Dt=Ke):(An=pt,Dt=qe),sn=b[fe],ii=V(nn(An,Oe),sn,K,0),Xn=V(nn(An+Dt,Oe),sn,K,0),jo(Li(ii,Xn),_n(Xn-ii))):jo(0,K),Ai&&En?(Wt==1?(An=Mt,Dt=Ke):(An=pt,Dt=qe),sn=b[_e],ii=P(nn(An,st),sn,le,0),Xn=P(nn(An+Dt,st),sn,le,0),Qo(Li(ii,Xn),_n(Xn-ii))):Qo(0,le)}else au()}else{let fe=_n(Jf-$f),_e=_n(Zf-Yf);if(R.ori==1){let st=fe;fe=_e,_e=st}wn=Ln.x&&fe>=Ln.dist,En=Ln.y&&_e>=Ln.dist;let Ne=Ln.uni;Ne!=null?wn&&En&&(wn=fe>=Ne,En=_e>=Ne,!wn&&!En&&(_e>fe?En=!0:wn=!0)):Ln.x&&Ln.y&&(wn||En)&&(wn=En=!0);let De,Oe;wn&&(R.ori==0?(De=Ur,Oe=Gt):(De=Fr,Oe=Yt),jo(Li(De,Oe),_n(Oe-De)),En||Qo(0,le)),En&&(R.ori==1?(De=Ur,Oe=Gt):(De=Fr,Oe=Yt),Qo(Li(De,Oe),_n(Oe-De)),wn||jo(0,K)),!wn&&!En&&(jo(0,0),Qo(0,0))}if(Ln._x=wn,Ln._y=En,_==null){if(N){if(cp!=null){let[fe,_e]=pn.scales;pn.values[0]=fe!=null?$i(R.ori==0?Gt:Yt,fe):null,pn.values[1]=_e!=null?$i(R.ori==1?Gt:Yt,_e):null}ta(Eu,n,Gt,Yt,z,Re,D)}if(Qe){let fe=N&&pn.setSeries,_e=ke.prox;sr==null?ps<=_e&&qi(Ns,kr,!0,fe):ps>_e?qi(null,kr,!0,fe):Ns!=sr&&qi(Ns,kr,!0,fe)}}pe&&(de.idx=D,su()),T!==!1&&Tn("setCursor")}let Ds=null;Object.defineProperty(n,"rect",{get(){return Ds==null&&ea(!1),Ds}});function ea(_=!1){_?Ds=null:(Ds=g.getBoundingClientRect(),Tn("syncRect",Ds))}function Qf(_,T,N,D,X,K,le){ue._lock||Is&&_!=null&&_.movementX==0&&_.movementY==0||(ru(_,T,N,D,X,K,le,!1,_!=null),_!=null?rr(null,!0,!0):rr(T,!0,!1))}function ru(_,T,N,D,X,K,le,fe,_e){if(Ds==null&&ea(!1),je(_),_!=null)N=_.clientX-Ds.left,D=_.clientY-Ds.top;else{if(N<0||D<0){Gt=-10,Yt=-10;return}let[Ne,De]=pn.scales,Oe=T.cursor.sync,[st,Et]=Oe.values,[Mt,pt]=Oe.scales,[Ke,qe]=pn.match,Wt=T.axes[0].side%2==1,nn=R.ori==0?z:Re,An=R.ori==1?z:Re,Dt=Wt?K:X,sn=Wt?X:K,ii=Wt?D:N,Xn=Wt?N:D;if(Mt!=null?N=Ke(Ne,Mt)?a(st,b[Ne],nn,0):-10:N=nn*(ii/Dt),pt!=null?D=qe(De,pt)?a(Et,b[De],An,0):-10:D=An*(Xn/sn),R.ori==1){let vi=N;N=D,D=vi}}_e&&(T==null||T.cursor.event.type==Eu)&&((N<=1||N>=z-1)&&(N=ur(N,z)),(D<=1||D>=Re-1)&&(D=ur(D,Re))),fe?($f=N,Yf=D,[Ur,Fr]=ue.move(n,N,D)):(Gt=N,Yt=D)}let ou={width:0,height:0,left:0,top:0};function au(){Qa(ou,!1)}let ep,tp,np,ip;function sp(_,T,N,D,X,K,le){Is=!0,wn=En=Ln._x=Ln._y=!1,ru(_,T,N,D,X,K,le,!0,!1),_!=null&&(bt(Tu,Iu,rp,!1),ta(em,n,Ur,Fr,z,Re,null));let{left:fe,top:_e,width:Ne,height:De}=Ht;ep=fe,tp=_e,np=Ne,ip=De}function rp(_,T,N,D,X,K,le){Is=Ln._x=Ln._y=!1,ru(_,T,N,D,X,K,le,!1,!0);let{left:fe,top:_e,width:Ne,height:De}=Ht,Oe=Ne>0||De>0,st=ep!=fe||tp!=_e||np!=Ne||ip!=De;if(Oe&&st&&Qa(Ht),Ln.setScale&&Oe&&st){let Et=fe,Mt=Ne,pt=_e,Ke=De;if(R.ori==1&&(Et=_e,Mt=De,pt=fe,Ke=Ne),wn&&Ls(E,$i(Et,E),$i(Et+Mt,E)),En)for(let qe in b){let Wt=b[qe];qe!=E&&Wt.from==null&&Wt.min!=Ot&&Ls(qe,$i(pt+Ke,qe),$i(pt,qe))}au()}else ue.lock&&(ue._lock=!ue._lock,rr(T,!0,_!=null));_!=null&&(vn(Tu,Iu),ta(Tu,n,Gt,Yt,z,Re,null))}function vy(_,T,N,D,X,K,le){if(ue._lock)return;je(_);let fe=Is;if(Is){let _e=!0,Ne=!0,De=10,Oe,st;R.ori==0?(Oe=wn,st=En):(Oe=En,st=wn),Oe&&st&&(_e=Gt<=De||Gt>=z-De,Ne=Yt<=De||Yt>=Re-De),Oe&&_e&&(Gt=Gt<Ur?0:z),st&&Ne&&(Yt=Yt<Fr?0:Re),rr(null,!0,!0),Is=!1}Gt=-10,Yt=-10,te.fill(null),rr(null,!0,!0),fe&&(Is=fe)}function op(_,T,N,D,X,K,le){ue._lock||(je(_),Ko(),au(),_!=null&&ta(im,n,Gt,Yt,z,Re,null))}function ap(){M.forEach(K_),B(n.width,n.height,!0)}pr(vl,$r,ap);let Br={};Br.mousedown=sp,Br.mousemove=Qf,Br.mouseup=rp,Br.dblclick=op,Br.setSeries=(_,T,N,D)=>{let X=pn.match[2];N=X(n,T,N),N!=-1&&qi(N,D,!0,!1)},me&&(bt(em,g,sp),bt(Eu,g,Qf),bt(tm,g,_=>{je(_),ea(!1)}),bt(nm,g,vy),bt(im,g,op),Bu.add(n),n.syncRect=ea);let el=n.hooks=i.hooks||{};function Tn(_,T,N){Wn?Lt.push([_,T,N]):_ in el&&el[_].forEach(D=>{D.call(null,n,T,N)})}(i.plugins||[]).forEach(_=>{for(let T in _.hooks)el[T]=(el[T]||[]).concat(_.hooks[T])});let lp=(_,T,N)=>N,pn=mn({key:null,setSeries:!1,filters:{pub:pm,sub:pm},scales:[E,x[1]?x[1].scale:null],match:[mm,mm,lp],values:[null,null]},ue.sync);pn.match.length==2&&pn.match.push(lp),ue.sync=pn;let cp=pn.key,lu=ug(cp);function ta(_,T,N,D,X,K,le){pn.filters.pub(_,T,N,D,X,K,le)&&lu.pub(_,T,N,D,X,K,le)}lu.sub(n);function yy(_,T,N,D,X,K,le){pn.filters.sub(_,T,N,D,X,K,le)&&Br[_](null,T,N,D,X,K,le)}n.pub=yy;function xy(){lu.unsub(n),Bu.delete(n),Sn.clear(),Du(vl,$r,ap),c.remove(),Ae?.remove(),Tn("destroy")}n.destroy=xy;function cu(){Tn("init",i,e),Zo(e||i.data,!1),H[E]?tu(E,H[E]):Ko(),se=Ht.show&&(Ht.width>0||Ht.height>0),ne=pe=!0,B(i.width,i.height)}return x.forEach(Rr),M.forEach(hs),t?t instanceof HTMLElement?(t.appendChild(c),cu()):t(n,cu):cu(),n}Nn.assign=mn;Nn.fmtNum=qu;Nn.rangeNum=yl;Nn.rangeLog=bl;Nn.rangeAsinh=Wu;Nn.orient=gr;Nn.pxRatio=Tt;Nn.join=Gx;Nn.fmtDate=Yu,Nn.tzDate=Qx;Nn.sync=ug;{Nn.addGap=U_,Nn.clipGaps=wl;let i=Nn.paths={points:vg};i.linear=xg,i.stepped=k_,i.bars=B_,i.spline=V_}function Sg(i,e,t){let{time:n,values:s}=i,r=n.length;if(r<=2*t)return i;let o=e/t,a=Math.floor((n[0]??0)/o),l=Math.floor((n[r-1]??0)/o)-a+1,c={time:new Float64Array(2*l),values:s.map(()=>new Float32Array(2*l).fill(NaN))};for(let h=0;h<2*l;h++)c.time[h]=(a+h/2)*o;return s.forEach((h,u)=>{let d=c.values[u];if(!d)return;let f=0;for(let g=0;g<l;g++){let[v,m,p,x]=[1/0,-1/0,-1,-1];for(;f<r&&Math.floor((n[f]??0)/o)-a<=g;f++){let M=h[f]??NaN;M<v&&([v,p]=[M,f]),M>m&&([m,x]=[M,f])}p<0||(d[2*g]=p<=x?v:m,d[2*g+1]=p<=x?m:v)}}),c}function wg(i){let[e,t]=[1/0,-1/0];for(let n of i)for(let s=0;s<n.length;s++){let r=n[s]??NaN;r<e&&(e=r),r>t&&(t=r)}return e<=t?[e,t]:null}var Cl=class{constructor(e){this.floor=e}floor;low=0;high=0;fit(e){let[t,n]=e?[Math.min(e[0],0),Math.max(e[1],0)]:[0,0],s=.08*Math.max(n-t,this.floor),[r,o]=[t<0?t-s:0,n>0||t===0?Math.max(n,t===0?this.floor:0)+s:0];return this.low=r<this.low?r:this.low+(r-this.low)*.04,this.high=o>this.high?o:this.high+(o-this.high)*.04,[this.low,Math.max(this.high,this.low+this.floor)]}};function Eg(i,e){let n=[i.map(s=>/[",\n]/.test(s)?`"${s.replaceAll('"','""')}"`:s).join(",")];for(let s=0;s<e.time.length;s++){let r=e.values.map(o=>Number.isNaN(o[s])?"":String(Number((o[s]??NaN).toPrecision(7))));n.push([(e.time[s]??NaN).toFixed(4),...r].join(","))}return`${n.join(`
`)}
`}var j_={N:.05,J:.2},Q_=[[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"]],eb=Array.from({length:22},(i,e)=>[1,2,5].map(t=>+`${t}e${e-14}`)).flat(),tb=.4;function td(i){return getComputedStyle(document.documentElement).getPropertyValue(i).trim()}function nb(i,e,t,n){let s=i.data[e],r=[],o=a=>i.valToPos(i.data[0][Math.min(Math.max(a,0),i.data[0].length-1)]??0,"x",!0);for(let a=t;s&&a<=n;a++){if(!Number.isNaN(s[a]))continue;let l=a;for(;l<n&&Number.isNaN(s[l+1]);)l++;(i.data[0][l+1]??1/0)-(i.data[0][a-1]??-1/0)>tb&&r.push([o(a-1),o(l+1)]),a=l}return r}var to=class{constructor(e,t,n,s,r,o,a){this.what=e;this.unit=t;this.lines=s;this.axis=new Cl(n),this.readout=s.map(d=>F("span",{class:"reading",title:d.name}));let l=F("div",{class:"chart-area",role:"img","aria-label":`${e} of the last ${r} s`});this.element=F("figure",{class:"chart"},F("figcaption",{"data-tip":a,tabindex:0},F("strong",null,e),this.unitWords,F("span",{class:"readings tabular"},...this.readout)),l);let c=()=>td("--muted"),h=()=>td("--rule"),u=`11px ${td("--sans")||"system-ui"}`;this.plot=new Nn({width:200,height:90,padding:[6,16,0,0],legend:{show:!1},cursor:{y:!1,drag:{x:!1,y:!1},points:{size:5},sync:{key:o}},scales:{x:{time:!1,range:[-r,0]},y:{range:()=>this.limits}},axes:[{stroke:c,font:u,size:20,gap:2,space:38,incrs:[1,2,5,10,20],grid:{stroke:h,width:1},ticks:{show:!1},values:(d,f)=>f.map(g=>g===0?"now":g===-r?"":`${Qi(g)} s`)},{stroke:c,font:u,size:38,gap:4,space:20,incrs:eb,grid:{stroke:h,width:1},ticks:{show:!1},values:(d,f,g,v,m)=>{let p=Math.max(0,-Math.floor(Math.log10(m/this.scale+1e-12)));return f.map(x=>Qi(x/this.scale,Math.min(p,3)))}}],series:[{},...s.map(d=>({label:d.name,stroke:d.colour,width:1.5,points:{show:!1},spanGaps:!1,gaps:(f,g,v,m)=>nb(f,g,v,m),...d.dash?{dash:d.dash}:{}}))],hooks:{setCursor:[()=>this.read()]}},[[],...s.map(()=>[])],l),this.observer=new ResizeObserver(([d])=>{let{width:f=0,height:g=0}=d?.contentRect??{};f>20&&g>20&&this.plot.setSize({width:Math.floor(f),height:Math.floor(g)})}),this.observer.observe(l)}what;unit;lines;element;unitWords=F("span",{class:"unit"});readout;plot;axis;scale=1;limits=[0,1];observer;draw(e,t){let n=new Float64Array(e.time.length);for(let a=0;a<n.length;a++)n[a]=(e.time[a]??0)-t;this.limits=this.axis.fit(wg(e.values));let s=Math.max(Math.abs(this.limits[0]),Math.abs(this.limits[1])),[r,o]=Q_.find(([a])=>s>=a*(j_[this.unit]??1))??[1e-9,"n"];this.scale=r,Fe(this.unitWords,o+this.unit),this.lines.forEach((a,l)=>{let c=this.plot.series[l+1];c&&(c.width=a.width())}),this.plot.setData([n,...e.values],!0),this.read()}redraw(){this.plot.redraw(!1,!0)}get canvas(){return this.plot.ctx.canvas}get caption(){return`${this.what} [${this.unitWords.textContent??""}]`}get room(){return Math.max(this.plot.width-46,100)}dispose(){this.observer.disconnect(),this.plot.destroy(),this.element.remove()}read(){let e=this.plot.cursor.idx,t=this.plot.data[0].length-1;this.lines.forEach((n,s)=>{let r=this.readout[s],o=this.plot.data[s+1];if(!r||!o)return;let a=o[e??t],l=this.scale>0&&Math.abs((a??0)/this.scale)<10?2:1;Fe(r,a==null||Number.isNaN(a)?"–":Qi(a/this.scale,l)),r.style.setProperty("--user",n.colour())})}};var ib=20,no=128;function Tg(i){let{store:e}=i,t=F("div",{class:"charts charts-one"}),n=new Float64Array(no),s=new Map,r=new Float32Array(no).fill(NaN),o=0,a=null,l=[],c="",h=v=>getComputedStyle(document.documentElement).getPropertyValue(v).trim(),u=v=>Ki(i.link.get(),v),d=()=>{let v=e.state;if(!v||o&&v.time<=(n[o-1]??0))return;if(o===no){n.copyWithin(0,1);for(let p of[...s.values(),r])p.copyWithin(0,1);o--}n[o]=v.time;for(let p of s.values())p[o]=NaN;for(let p of l){let x=s.get(Yn(p))??new Float32Array(no).fill(NaN);s.set(Yn(p),x),x[o]=Ri(v,...p,"ages")??NaN}let m=i.link.get();r[o]=(m&&Ri(v,...m,"budget"))??NaN,o++;for(let[p,x]of s)x.subarray(0,o).every(Number.isNaN)&&s.delete(p)},f=()=>{let v=(e.state?.links??[]).map(([p,x])=>Zi(p,x)),m=JSON.stringify([e.scene?.started,v]);m!==c&&(c.startsWith(JSON.stringify([e.scene?.started]).slice(0,-1))||([n,s,r,o]=[new Float64Array(no),new Map,new Float32Array(no).fill(NaN),0]),c=m,l=v,a?.dispose(),a=null,l.length&&(a=new to("Ages there and back","s",.01,[...l.map(p=>({name:es(...p),colour:()=>h(u(p)?"--accent":"--faint"),width:()=>u(p)?2.25:1})),{name:"budget",colour:()=>h("--warn"),width:()=>1.25,dash:[5,4]}],ib,"ages","Sum of the ages at both ends of every link. Choose a link to make it and its budget stand out"),t.replaceChildren(a.element))),d(),g()},g=()=>{if(!a||!o||t.offsetParent===null)return;let v={time:n.subarray(0,o),values:[...l.map(m=>s.get(Yn(m))?.subarray(0,o)??new Float32Array(o).fill(NaN)),r.subarray(0,o)]};a.draw(v,n[o-1]??0)};return e.on("state",f),e.on("settings",()=>a?.redraw()),i.link.on(()=>{r.fill(NaN),g()}),i.tab.on(g),t}var sb="Passive means: whatever the users do, the session as a whole never gives out more energy than hands put in, so nothing can start to swing by itself. It holds as long as each copy’s damping is at least what the ages on its links ask for. Damping is made for a budget of ages on each link; what ages leave of it is to spare. A link that goes over its budget is guarded: it then spends only what it has saved.",[Rg,rb]=[.1,100],nd={skin:1,bare:5};function Ag(i){return Math.min(Number((Rg*10**(i/10)).toPrecision(2)),95)}var id=i=>Math.round(10*Math.log10(i/Rg)),Cg=id(rb);function ob(i){let e=F("output",{class:"tabular"}),t=F("input",{type:"range",min:0,max:Cg,step:1,value:id(nd.bare),"aria-label":"Share of the damping that is needed"}),n=()=>{let o=`${Ag(Number(t.value))} % of what is needed`;Fe(e,o),We(t,"aria-valuetext",o),t.style.setProperty("--share",`${Number(t.value)/Cg*100}%`)};t.addEventListener("input",n),n();let s=Hr("Lower the damping",[F("p",{class:"warning"},an("warn",20),F("span",null,"Below what the delays need, nothing keeps energy from growing: copies begin to shake by themselves, and shake harder until they are stopped. That is what you will see, in numbers and in the picture.")),F("p",null,"Do this with simulated hands only. Let go of any real device first."),F("label",{class:"slider"},F("span",null,"damping"),t,e),F("p",{class:"hint"},"Scripted hands let go meanwhile. A copy that runs away restores the damping of all by itself; so does one click on the banner.")],[{words:"Lower it",class:"button danger",act:()=>{i.act("damping",{share:Number((Ag(Number(t.value))/100).toPrecision(3))})}},{words:"Leave it as it is",class:"button primary",act:()=>{},focus:!0}]),r;return{open:()=>{let{scene:o}=i.store;o&&o.started!==r&&(r=o.started,t.value=String(id(o.skin?nd.skin:nd.bare)),n()),s.open()}}}function Pg(i){let{store:e}=i,t=ob(i),n=Ye("Lower damping …",()=>t.open(),{icon:"warn",class:"button small danger",id:"lower",tip:"Shows what the damping is for"}),s=Ye("Restore damping",()=>{i.act("damping",{share:1})},{class:"button small primary"}),{element:r,body:o}=_i("margin","Margin",sb,n,s),a=an("good",18),l=F("span",null),c=F("p",{class:"certificate"},a,l),h=F("tbody"),u=F("tbody");o.append(c,F("table",{class:"numbers"},F("thead",null,F("tr",null,...["link","ages","of budget","to spare",""].map(f=>F("th",{scope:"col"},f)))),h),Tg(i),F("table",{class:"numbers"},F("thead",null,F("tr",null,F("th",{scope:"col"},"user"),F("th",{scope:"col","data-tip":"Largest coefficient of the damping of the copy",tabindex:0},"damping"),F("th",{scope:"col","data-tip":"What the damping exceeds what the budgets in force need by",tabindex:0},"above need"))),u));let d=()=>{let f=e.state,g=!!f&&f.damping<1;if(St(n,!g),St(s,g),n.disabled=s.disabled=!At(i,"damping"),!f||o.offsetParent===null)return;We(c,"data-level",f.verdict.level),Cn(a,f.verdict.level),Fe(l,f.verdict.text);let v=f.links.map(([M,b])=>Zi(M,b)),m=JSON.stringify([v,e.scene?.started]);h.dataset.key!==m&&(h.dataset.key=m,h.replaceChildren(...v.map(M=>F("tr",{"data-link":Yn(M)},F("th",{scope:"row"},Ye(es(...M),()=>i.link.set(M),{class:"plain",label:`Open link ${es(...M)}`})),F("td"),F("td"),F("td",{class:"gauge"},F("i"),F("span")),F("td",{class:"word"}))))),v.forEach((M,b)=>{let C=h.children[b]?.children;if(!C)return;let E=Wr(f,...M),y=cl(f,...M);We(h.children[b],"data-condition",E),We(h.children[b],"data-chosen",Ki(M,i.link.get())?"":null),Fe(C[1],kn(Ri(f,...M,"ages"))),Fe(C[2],kn(Ri(f,...M,"budget")));let S=C[3];S.style.setProperty("--share",`${Math.round(100*Math.min(Math.max(1-(y??1),0),1))}%`),We(S,"data-level",y===null?null:y<0?"bad":y<.1?"warn":"good"),Fe(S.lastElementChild,y===null?"–":y<0?`${Rn(-y,0)} over`:Rn(y,0)),Fe(C[4],oi[E].words)});let p=Object.keys(f.members).map(Number).sort((M,b)=>M-b),x=JSON.stringify([p,e.scene?.started]);u.dataset.key!==x&&(u.dataset.key=x,u.replaceChildren(...p.map(M=>F("tr",null,F("th",{scope:"row"},F("span",{class:"badge tiny",style:`--user:var(--user-${M});--on-user:var(--on-user-${M})`},String(M+1))," ",Ut(e,M)),F("td"),F("td"))))),p.forEach((M,b)=>{let C=u.children[b]?.children,E=f.members[M];if(!C||!E)return;Fe(C[1],E.steps?`${Qi(E.damping,2)} N·s/m`:"–");let y=E.certificate;Fe(C[2],typeof y=="number"?Rn(y):"–"),We(C[2],"data-level",typeof y=="number"?y<0?"bad":"good":null)})};return e.on("state",d),e.on("connection",d),i.tab.on(d),i.link.on(d),d(),r}var ab="The last 20 seconds of every copy, in the colours of the users; the line of the user that this page acts for is wider. Position is the mean displacement along the axis that moves most, force is the hand’s on the copy, energy is what the copy holds in motion and springs. Move over a plot to read values; without, the newest are shown. Saved numbers are not thinned.",lb=45,Rl=[{kind:"position",what:"Position",unit:"m",floor:.002,tip:"Mean displacement of each copy from rest"},{kind:"force",what:"Force",unit:"N",floor:.05,tip:"Of each user’s hand on his copy"},{kind:"energy",what:"Energy",unit:"J",floor:1e-5,tip:"In each copy: of its motion and its springs"}];function Ig(i,e){let t=URL.createObjectURL(e);F("a",{href:t,download:i}).click(),setTimeout(()=>URL.revokeObjectURL(t),1e3)}function Lg(i){let{store:e}=i,t=null,n=0,s=[],r=[],o=0,a=-1,l=M=>t?.get(M)??{time:e.history.time(),values:r.map(b=>e.history.series(M,b))},c=()=>{if(t)return n;let M=e.frame;return M?M.time+Math.min((performance.now()-M.received)/1e3,e.connection==="open"?.25:0):0},h=()=>{t?t=null:(n=c(),t=new Map(Rl.map(({kind:b})=>[b,l(b)])));let M=u.querySelector("svg");M&&Cn(M,t?"play":"pause"),Fe(u.lastElementChild??u,t?"Go on":"Freeze"),u.setAttribute("aria-pressed",String(!!t)),g.toggleAttribute("data-frozen",!!t),a=-1},u=Ye("Freeze",h,{icon:"pause",class:"button small",id:"freeze"}),d=Ye("CSV",()=>{let[M,...b]=Rl.map(({kind:S,what:U,unit:L})=>({what:U,unit:L,table:l(S)}));if(!M)return;let C=[M,...b],E=["time_s",...C.flatMap(({what:S,unit:U})=>r.map(L=>`${S.toLowerCase()}_${U} ${L+1} ${Ut(e,L)}`))],y=Eg(E,{time:M.table.time,values:C.flatMap(S=>S.table.values)});Ig("cotouch.csv",new Blob([y],{type:"text/csv"}))},{icon:"save",class:"button small",label:"Save the numbers as CSV"}),f=Ye("PNG",()=>{cb(i,s,r)?.toBlob(M=>M&&Ig("cotouch.png",M))},{icon:"save",class:"button small",label:"Save the plots as a picture"}),{element:g,body:v}=_i("plots","Plots",ab,u,d,f);v.classList.add("charts");let m="",p=()=>{let M=e.scene,b=M?JSON.stringify([M.started,M.users]):"";if(b!==m){m=b,t&&h();for(let C of s)C.dispose();r=(M?.users??[]).map(C=>C.seat),s=Rl.map(({what:C,unit:E,floor:y,tip:S})=>new to(C,E,y,r.map(U=>({name:Ut(e,U),colour:()=>xi(U,Us(e.settings.theme)),width:()=>U===e.seat?2.25:1.25})),e.history.seconds,"users",S)),v.replaceChildren(...s.map(C=>C.element)),a=-1}},x=M=>{if(requestAnimationFrame(x),M-o<lb||!s.length||v.offsetParent===null||a===e.history.version&&(t||e.connection!=="open")||t&&a>=0)return;o=M,a=e.history.version;let b=c();Rl.forEach(({kind:C},E)=>{let y=s[E];y?.draw(Sg(l(C),e.history.seconds,y.room),b)})};return e.on("scene",p),e.on("settings",()=>{for(let M of s)M.redraw()}),p(),requestAnimationFrame(x),{element:g,freeze:h}}function cb(i,e,t){if(!e[0]?.canvas)return null;let s=getComputedStyle(document.documentElement),r=devicePixelRatio||1,o=22*r,a=F("canvas",{width:Math.max(...e.map(f=>f.canvas.width))+2*o,height:e.reduce((f,g)=>f+g.canvas.height+o,3*o)}),l=a.getContext("2d");if(!l)return null;l.fillStyle=s.getPropertyValue("--panel"),l.fillRect(0,0,a.width,a.height),l.textBaseline="middle";let c=(f,g,v,m,p)=>(l.font=`${m} ${12*r}px system-ui, sans-serif`,l.fillStyle=p,l.fillText(f,g,v),l.measureText(f).width),h=s.getPropertyValue("--ink"),u=o;for(let f of t)l.fillStyle=xi(f,Us(i.store.settings.theme)),l.fillRect(u,o-5*r,10*r,10*r),u+=15*r,u+=c(Ut(i.store,f),u,o,400,h)+16*r;let d=2*o;for(let f of e)c(f.caption,o,d,600,h),l.drawImage(f.canvas,o,d+o/2),d+=f.canvas.height+o;return a}var Ng=350;function Dg(i){let e=F("div",{class:"tip",role:"tooltip",id:"tip",hidden:!0});i.append(e);let t=0,n=null,s=()=>{clearTimeout(t),e.hidden=!0,n?.removeAttribute("aria-describedby"),n=null},r=a=>{let l=a.getAttribute("data-tip");if(!l||!a.isConnected)return;Fe(e,l),(a.closest("dialog")??i).append(e),e.hidden=!1,a.setAttribute("aria-describedby","tip");let c=a.getBoundingClientRect(),h=e.getBoundingClientRect(),u=Math.min(Math.max(c.left+c.width/2-h.width/2,8),innerWidth-h.width-8),d=c.bottom+8+h.height<innerHeight;e.style.left=`${u}px`,e.style.top=`${d?c.bottom+8:c.top-h.height-8}px`},o=(a,l)=>{let c=a.target?.closest?.("[data-tip]")??null;c!==n&&(s(),c&&(n=c,t=window.setTimeout(()=>r(c),l)))};document.addEventListener("pointerover",a=>{a.pointerType!=="touch"&&o(a,Ng)}),document.addEventListener("focusin",a=>{a.target.matches(":focus-visible")&&o(a,Ng)}),document.addEventListener("focusout",s),document.addEventListener("pointerdown",s,!0),document.addEventListener("keydown",s,!0),document.addEventListener("scroll",s,!0)}function Ug(i,e){let{store:t}=i,n=lr("Tool",[{value:"grab",words:"Grab",icon:"grab",tip:"Take hold of a point and draw it (B changes the tool)"},{value:"ball",words:"Ball",icon:"ball",tip:"Push with a ball; Shift and wheel change its size"}],h=>t.set({tool:h})),s=lr("Copies",[{value:"overlay",words:"Overlaid",icon:"overlay",tip:"All copies in one place (S)"},{value:"side",words:"Side by side",icon:"side",tip:"Each copy by itself: see how late the others are (S)"}],h=>t.set({layout:h})),r=F("select",{"aria-label":"Colour of the object","data-tip":"What colours show (C)"},F("option",{value:"displacement"},"Displacement"),F("option",{value:"stress"},"Stretch"),F("option",{value:"plain"},"Plain"));r.addEventListener("change",()=>t.set({colour:r.value}));let o=Ye("Ghosts",()=>t.set({ghosts:!t.settings.ghosts}),{icon:"ghosts",class:"button small toggle",tip:"Show what others’ copies look like over yours"}),a=Ye("",e,{icon:"reset",class:"button small bare",label:"Look from the start again",tip:"Look from where you looked at first (0)"}),l=F("div",{class:"toolbar",id:"toolbar",role:"toolbar","aria-label":"Picture"},F("span",{class:"space-only"},n.element),F("span",{class:"space-only"},s.element),F("span",{class:"space-only select"},r),o,a),c=()=>{let{settings:h,scene:u}=t;n.mark(h.tool),s.mark(h.layout),r.value=h.colour,We(o,"aria-pressed",String(h.ghosts)),We(l,"data-dimension",u?String(u.dimension):null),o.disabled=u?.dimension!==1&&h.layout==="side"};return t.on("settings",c),t.on("scene",c),c(),l}var od="cotouch.tour",hb=200,fa=(i,e)=>t=>At(t,i)?null:e,Og=i=>i.store.frame?.copies.find(e=>e.seat===i.store.seat),Vs=i=>{let e=Og(i);return e?.mode==="grab"||e?.mode==="ball"},Fg=i=>Math.hypot(...Og(i)?.force??[0,0,0]),Pl=fa("hand","This page may only watch; go on with →."),sd=i=>i.map(([e,t])=>Yn(Zi(e,t))).sort().join(" "),Ni=[{title:"Take hold",words:"This is one object, held by several people. Each of them has a copy of it, and yours is the solid one.",task:"Press on the object, and draw.",where:"#stage",needs:Pl,done:i=>Vs(i)&&Fg(i)>.02},{title:"Let go",words:"What you feel is a spring between your pointer and the point you hold. The others feel you through springs between the copies.",task:"Release, and watch the object swing back and come to rest.",where:"#stage",needs:Pl,done:(i,e)=>(Vs(i)&&(e.held=!0),!!e.held&&!Vs(i))},{title:"See the delay",words:"News travels tens of milliseconds. The other copies do what yours did, but later.",task:"Choose Side by side (or Ghosts), then draw again and look at the others.",where:"#stage-frame",needs:Pl,done:(i,e)=>{let{layout:t,ghosts:n}=i.store.settings,s=e.first??=`${t} ${n}`;return(t==="side"||`${t} ${n}`!==s)&&(e.seen=!0),!!e.seen&&Vs(i)}},{title:"Pull against somebody",words:"A scripted hand can be told what to do. Two who pull against each other feel each other’s force, through the network.",task:"Unfold another user, tell the hand Hold or Pull, and draw the other way.",where:i=>i.told?"#stage":"#users",tab:"users",needs:Pl,done:(i,e)=>{let{state:t,seat:n}=i.store;return Object.entries(t?.members??{}).some(([r,o])=>Number(r)!==n&&(o.hand==="hold"||o.hand==="pull"))&&(e.told=!0),!!e.told&&Vs(i)&&Fg(i)>.02}},{title:"Look at a link",words:"Lines join users. The number is how old the news is that a copy works with. Damping is set so that this age can do no harm.",task:"Choose a link to see both its ends.",where:"#network",tab:"network",done:i=>i.link.get()!==null},{title:"Cut it",words:"Networks fail. When news stays away, both ends let go of their spring without a kick, and everybody else goes on.",task:"Press Cut, and watch the line and the verdict on top.",where:"#link, #network",tab:"network",needs:fa("cut","Links cannot be cut from here; go on with →."),done:({store:i})=>!!i.state?.links.some(([e,t])=>i.state&&hr(i.state,e,t))},{title:"Mend it",words:"When news comes again, the ends first catch up and save energy, and couple only when both can pay for it.",task:"Press Mend, and wait until the link is coupled again.",where:"#link, #network",tab:"network",needs:fa("cut","Links cannot be mended from here; go on with →."),done:({store:i},e)=>{let t=!!i.state?.links.some(([n,s])=>i.state&&hr(i.state,n,s));return t&&(e.cut=!0),!!i.state&&!t&&(!!e.cut||e.looked===!0)}},{title:"Join them badly",words:"Over which links users are joined matters. With the worst choice of as many links copies agree late; with the best, soonest.",task:"Choose Worst, draw and let go; then choose Best.",where:"#topology",tab:"network",needs:fa("links","Links are not chosen here; go on with →."),done:({store:i},e)=>{let{state:t}=i;if(!t)return!1;let n=sd(t.links);return t.choices.worst&&sd(t.choices.worst)===n&&(e.worst=!0),!!e.worst&&!!t.choices.best&&sd(t.choices.best)===n}},{title:"Follow the energy",words:"Every joule is booked: put in by hands, added by delays, damped, or still in the copies. Both bars are equally long, always.",task:"Open Energy, and put some in.",where:"#energy",tab:"energy",done:(i,e)=>{let t=Object.values(i.store.state?.members??{}).reduce((s,r)=>s+Math.abs(r.supplied??0),0),n=e.first??=t;return i.tab.get()==="energy"&&(Math.abs(t-n)>1e-6||!At(i,"hand"))}},{title:"Take the guarantee away",words:"Below the damping that delays ask for, nothing keeps energy from growing. See it once, then restore it: the copies come to rest.",task:"Lower the damping, watch, and press Restore now.",where:"#margin, #banner-damping",tab:"margin",needs:fa("damping","Damping is not changed from here; this was the last step."),done:({store:i},e)=>{let t=i.state?.damping??1;return t<1&&(e.lowered=!0),!!e.lowered&&t===1}}];function ub(){try{let{step:i=0,over:e=!1}=JSON.parse(localStorage.getItem(od)??"{}");return{step:Math.min(Math.max(Math.floor(Number(i))||0,0),Ni.length-1),over:e===!0}}catch{return{step:0,over:!1}}}function rd(i,e){try{localStorage.setItem(od,JSON.stringify({step:i,over:e}))}catch{}}function kg(i,e){let t=0,n={},s=!1,r=new Set,o=F("div",{class:"tour-hole",hidden:!0,"aria-hidden":"true"}),a=F("p",{class:"tour-number tabular"}),l=F("h2",{id:"tour-title"}),c=F("p",{id:"tour-words"}),h=an("play",16),u=F("span",null),d=F("p",{class:"tour-task",role:"status"},h,u),f=F("div",{class:"tour-dots","aria-hidden":"true"},...Ni.map(()=>F("i"))),g=Ye("Back",()=>S(t-1),{class:"button small",label:"Step before (←)"}),v=Ye("Next",()=>t+1<Ni.length?S(t+1):L(!0),{class:"button small",label:"Next step (→)",id:"tour-next"}),m=Ye("",()=>L(!1),{icon:"close",class:"button bare",label:"Leave the tour (Esc); it can be taken up again"}),p=F("div",{class:"tour-card",id:"tour",role:"dialog","aria-modal":"false","aria-labelledby":"tour-title","aria-describedby":"tour-words",tabindex:-1,hidden:!0},F("div",{class:"panel-head"},a,F("div",{class:"grow"}),m),l,c,d,F("div",{class:"tour-foot"},f,F("div",{class:"grow"}),g,v)),x=Ye("Start",()=>U(),{class:"button small primary"}),M=Ye("Not now",()=>{St(b,!1),rd(t,!0)},{class:"button small"}),b=F("div",{class:"tour-offer",id:"tour-offer",role:"region","aria-label":"Tour",hidden:!0},an("tour",18),F("span",null,"New here? Two minutes show you everything."),x,M);e.append(o,p,b);let C=()=>{let R=Ni[t]?.where??"";for(let O of(typeof R=="string"?R:R(n)).split(", ")){let V=document.querySelector(O);if(V&&V.getClientRects().length)return V}return null},E=()=>{if(!s)return;let R=C();o.hidden=!R;let O=p.getBoundingClientRect(),V=innerWidth<720;if(!R)return;let P=R.getBoundingClientRect(),H=4,[Y,k]=[Math.max(P.left-H,2),Math.max(P.top-H,2)];if(Object.assign(o.style,{left:`${Y}px`,top:`${k}px`,width:`${Math.min(P.right+H,innerWidth-2)-Y}px`,height:`${Math.min(P.bottom+H,innerHeight-2)-k}px`}),V){let de=P.top+P.height/2<innerHeight/2;p.style.left="8px",p.style.top=de?`${innerHeight-O.height-64}px`:"56px";return}let re=P.width>innerWidth*.4,q=P.right+12+O.width<innerWidth,j=re?P.left+16:q?P.right+12:P.left-O.width-12,te=re?P.bottom-O.height-16:Math.min(Math.max(P.top,60),innerHeight-O.height-12);p.style.left=`${Math.max(j,8)}px`,p.style.top=`${Math.max(te,8)}px`},y=()=>{let R=Ni[t];if(!s||!R)return;let O=R.needs?.(i)??null;!r.has(t)&&O===null&&R.done(i,n)&&(r=new Set([...r,t]),i.say(t+1<Ni.length?"Done. Go on when you like.":"That was everything.","good"));let V=r.has(t);We(p,"data-done",V?"":null),Cn(h,V?"tick":O?"wait":"play"),Fe(u,O??R.task),We(v,"class",`button small${V?" primary":""}`),Fe(v.lastElementChild??v,t+1===Ni.length?"Finish":V?"Next":"Skip"),E()},S=R=>{t=Math.min(Math.max(R,0),Ni.length-1);let O=Ni[t];O&&(n={looked:!0},rd(t,!1),O.tab&&i.tab.set(O.tab),Fe(a,`Step ${t+1} of ${Ni.length}`),Fe(l,O.title),Fe(c,O.words),g.disabled=t===0,[...f.children].forEach((V,P)=>We(V,"class",P===t?"here":r.has(P)?"done":null)),y())},U=()=>{s=!0,St(b,!1),p.hidden=!1,S(ub().step),p.focus({preventScroll:!0})},L=R=>{s=!1,p.hidden=o.hidden=!0,rd(R?0:t,!0),R?r=new Set:i.say(`You can take the tour up again at step ${t+1}.`),document.getElementById("tour-open")?.focus()};return document.addEventListener("keydown",R=>{if(!s||document.querySelector("dialog[open]"))return;let O=p.contains(document.activeElement)||document.activeElement===document.body;if(R.key==="Escape"&&O&&!Vs(i))L(!1);else if(R.key==="ArrowRight"&&O&&!Vs(i))t+1<Ni.length?S(t+1):L(!0);else if(R.key==="ArrowLeft"&&O&&!Vs(i))S(t-1);else return;R.preventDefault(),R.stopPropagation()},!0),addEventListener("resize",E),setInterval(y,hb),{open:U,invite:()=>{let R=!1;try{R=localStorage.getItem(od)===null}catch{}R&&!s&&St(b,!0)}}}var db={users:"Users",network:"Network",plots:"Plots",energy:"Energy",margin:"Margin",events:"Events"},Bg=4500;function fb(){let i=an("good",16),e=F("span",null),t=F("div",{class:"toast",hidden:!0,"aria-hidden":"true"},i,e),n=F("div",{class:"unseen",role:"status","aria-live":"polite",id:"spoken"}),s=0;return{element:F("div",{class:"toasts"},t,n),say(r,o="info"){let a=r.slice(0,1).toUpperCase()+r.slice(1);Fe(e,a),Fe(n,a),We(t,"data-level",o),Cn(i,o==="info"?"wait":o),t.hidden=!1,clearTimeout(s),s=window.setTimeout(()=>t.hidden=!0,o==="bad"?2*Bg:Bg)}}}function pb(i){let e=yp.map(s=>{let r=F("button",{type:"button",role:"tab",id:`tab-${s}`,"aria-controls":s,"data-tab":s},db[s]);return r.addEventListener("click",()=>i.tab.set(s)),r}),t=F("div",{class:"tabs",role:"tablist","aria-label":"Instruments"},...e);t.addEventListener("keydown",s=>{let r={ArrowRight:1,ArrowLeft:-1}[s.key];if(!r)return;let o=e.filter(c=>c.getClientRects().length),a=o.indexOf(document.activeElement),l=o[(a+r+o.length)%o.length];l?.focus(),l?.dataset.tab&&i.tab.set(l.dataset.tab),s.preventDefault(),s.stopPropagation()});let n=()=>{let s=i.tab.get();document.documentElement.dataset.tab=s;let r=["energy","margin","events"].includes(s);document.documentElement.dataset.side=r?s:document.documentElement.dataset.side??"energy";let o=matchMedia("(max-width: 899px)").matches?s:document.documentElement.dataset.side;for(let a of e)We(a,"aria-selected",String(a.dataset.tab===o)),a.tabIndex=a.dataset.tab===o?0:-1};return i.tab.on(n),matchMedia("(max-width: 899px)").addEventListener("change",n),n(),t}function mb(i,e,t){let n=s=>{let r=i.aiming.get();if(!r||!e.contains(s.target)||(s.preventDefault(),s.stopImmediatePropagation(),s.type!=="pointerdown"))return;let o=t()?.aim(s.clientX,s.clientY)??null;if(!o)return i.say("There is nothing of the object there; click nearer to it.","warn");i.aiming.set(null);let a=i.store.frame?.copies.find(c=>c.seat===r.seat)?.node??-1,l=a>=0?a:i.store.scene?.skin?.node[o.point]??o.point;i.act("hand",{seat:r.seat,mode:"pull",node:l,to:o.to})};for(let s of["pointerdown","pointermove","pointerup"])addEventListener(s,n,!0);addEventListener("keydown",s=>{s.key!=="Escape"||s.defaultPrevented||(i.aiming.get()?i.aiming.set(null):document.querySelector("dialog[open]")||i.link.set(null))}),i.aiming.on(s=>e.toggleAttribute("data-aiming",s!==null))}function gb(i){let e=-1/0,t="";i.store.on("state",()=>{let n=i.store.state;if(!n)return;let s=n.events.at(-1);s&&s.time>e&&(e>-1/0&&Fe(document.getElementById("spoken")??document.createElement("i"),s.text),e=s.time),t&&t!==n.verdict.level&&i.say(n.verdict.text,n.verdict.level),t=n.verdict.level}),i.store.on("scene",()=>{i.store.state||([e,t]=[-1/0,""])})}function zg(i,e,t){let n=fb(),s={store:e,connection:t,link:new ar(null),opened:new ar(null),tab:new ar("energy"),aiming:new ar(null),say:n.say,async act(m,p={},x=!1){let M=await t.do(m,p);return(!M.ok||!x)&&n.say(M.text||(M.ok?"Done.":"It was refused."),M.ok?"good":"bad"),M.ok}},r=null,o=F("div",{id:"stage"}),a=()=>r?.reset(),l=Dp(s),c=kg(s,i),h=Lg(s),u=Tp(s,{tour:c.open,invite:l.open,keys:()=>d.open()}),d=kp(s,{tour:c.open,invite:l.open,record:u.record,freeze:h.freeze,reset:a}),f=F("main",{class:"layout"},Fp(s),F("div",{id:"stage-frame"},o,Ug(s,a),Zp(s),n.element),h.element,Jp(s),pb(s),Pp(s),Pg(s),Ip(s)),g=Ye("To the object",()=>o.querySelector(".ct-canvas")?.focus(),{class:"skip"});i.classList.add("shell"),i.prepend(g,u.element,Sp(s),f),matchMedia("(max-width: 899px)").matches&&s.tab.set("users"),s.opened.on(m=>m!==null&&r?.pulse(m)),mb(s,o,()=>r),gb(s),Dg(i);let v=e.on("scene",()=>{v(),c.invite()});return{stageElement:o,attach:m=>r=m}}function ad(i,e,t){let n=i.emulated[`${e}-${t}`];if(n?.cut)return null;if(n&&n.delay+n.jitter>0)return n.delay+n.jitter;let s=i.ends[`${e}-${t}`];return s?.ages!=null?s.ages/2:s?.path!=null?s.path/2:n?n.delay:null}function Il(i,e){let t=new Map([[e,0]]),n=new Set;for(;;){let s=-1;for(let[r,o]of t)!n.has(r)&&(s<0||o<t.get(s))&&(s=r);if(s<0)return t;n.add(s);for(let[r,o]of i.links){if(r!==s&&o!==s)continue;let a=r===s?o:r,l=ad(i,a,s);if(l===null)continue;let c=t.get(s)+l;c<(t.get(a)??1/0)&&t.set(a,c)}}}function Gs(i){return i<.9995?`${Math.round(i*1e3)} ms`:`${i.toFixed(1)} s`}function Ll(i,e=i){let t=Math.abs(e),[n,s]=t<95e-5?[1e6,"µm"]:t<.095?[1e3,"mm"]:t<.95?[100,"cm"]:[1,"m"],r=i*n;return`${r.toFixed(Math.abs(r)<9.95&&r!==Math.round(r)?1:0).replace("-","−")} ${s}`}function Nl(i){return`${i.toFixed(i<.995?2:i<9.95?1:0)} N`}function io(i){let e=10**Math.floor(Math.log10(Math.max(i,1e-12)));for(let t of[1,2,5,10])if(t*e>=i*.9999)return t*e;return 10*e}var ld={displacement:"displacement",stress:"stretch",plain:""},so=class{root=document.createElement("div");key=document.createElement("figure");what=document.createElement("figcaption");most=document.createElement("span");hint=document.createElement("p");lines=document.createElement("div");off;constructor(e,t,n){this.root.className="ct-furniture",this.key.className="ct-legend";let s=document.createElement("i");s.style.background=`linear-gradient(to right, ${nl.join(", ")})`;let r=document.createElement("span");r.textContent="0",this.key.append(this.what,r,s,this.most),this.hint.className="ct-hint",this.hint.textContent=n,this.lines.className="ct-lines",this.root.append(this.lines,this.key,this.hint),e.append(this.root),this.off=t.on("frame",()=>{let o=t.frame?.copies.find(a=>a.seat===t.seat)?.mode;(o==="grab"||o==="ball")&&this.told()})}told(){this.hint.hidden=!0,this.off()}legend(e,t){this.key.hidden=!ld[e],this.what.textContent!==ld[e]&&(this.what.textContent=ld[e]),this.most.textContent!==t&&(this.most.textContent=t)}rules(e){this.lines.replaceChildren(...e.map(({x:t,y:n,width:s,height:r})=>{let o=document.createElement("i");return Object.assign(o.style,{left:`${t}px`,top:`${n}px`,width:`${s}px`,height:`${r}px`}),o}))}dispose(){this.off(),this.root.remove()}};var vb=[[148,158,172],[232,160,30],[208,48,42]],yb=[[122,133,150],[245,185,66],[255,107,91]];function pa(i,e){let t=e?yb:vb,n=Math.min(Math.max(i,0),1)/.4,s=n<1?0:1;return`#${t[s].map((o,a)=>Math.round(o+(t[s+1][a]-o)*(s?(n-1)/1.5:n))).map(o=>o.toString(16).padStart(2,"0")).join("")}`}var ro=class{held=!1;told=0;read(){let e=this.first();if(!e)return null;let t=!!e.buttons[0]?.pressed,n={x:e.axes[0]??0,y:e.axes[1]??0,depth:-(e.axes[3]??0),pressed:t&&!this.held,released:!t&&this.held};return this.held=t,n}rumble(e){let t=performance.now(),n=this.first()?.vibrationActuator;if(!n||t-this.told<90||e<.03)return;this.told=t;let s=Math.min(e,1);n.playEffect("dual-rumble",{duration:90*1.5,strongMagnitude:s**2,weakMagnitude:s}).catch(()=>{})}first(){try{return navigator.getGamepads?.().find(e=>e?.connected)??null}catch{return null}}};var p0=0,kd=1,m0=2;var Fa=1,g0=2,No=3,nr=0,jn=1,os=2,wr=0,Do=1,Bd=2,zd=3,Vd=4,v0=5;var Er=100,y0=101,x0=102,_0=103,b0=104,M0=200,S0=201,w0=202,E0=203,Gd=204,Hd=205,T0=206,A0=207,C0=208,R0=209,P0=210,I0=211,L0=212,N0=213,D0=214,oc=0,ac=1,lc=2,bo=3,cc=4,hc=5,Mo=6,uc=7,Wd=0,U0=1,F0=2,as=0,Xd=1,qd=2,$d=3,Yd=4,Jd=5,Zd=6,Kd=7;var jd=300,Tr=301,Uo=302,Vc=303,Gc=304,dc=1e3,ss=1001,fc=1002,In=1003,O0=1004;var Oa=1005;var Dn=1006,Hc=1007;var Oi=1008;var gi=1009,Qd=1010,ef=1011,Fo=1012,Wc=1013,ki=1014,Bi=1015,zi=1016,Xc=1017,qc=1018,Ar=1020,tf=35902,nf=35899,sf=1021,rf=1022,Vi=1023,Ss=1026,As=1027,of=1028,$c=1029,ir=1030,Yc=1031;var Jc=1033,ka=33776,Ba=33777,za=33778,Va=33779,Zc=35840,Kc=35841,jc=35842,Qc=35843,eh=36196,th=37492,nh=37496,ih=37488,sh=37489,Ga=37490,rh=37491,oh=37808,ah=37809,lh=37810,ch=37811,hh=37812,uh=37813,dh=37814,fh=37815,ph=37816,mh=37817,gh=37818,vh=37819,yh=37820,xh=37821,_h=36492,bh=36494,Mh=36495,Sh=36283,wh=36284,Ha=36285,Eh=36286;var ba=2300,pc=2301,sc=2302,Id=2303,Ld=2400,Nd=2401,Dd=2402;var k0=3200;var af=0,B0=1,Cs="",di="srgb",Ma="srgb-linear",Sa="linear",Rt="srgb";var rc=7680;var z0=519,V0=512,G0=513,H0=514,lf=515,W0=516,X0=517,cf=518,hf=519,q0=35044,Th=35048;var uf="300 es",wi=2e3,wa=2001;function xb(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function _b(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ea(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function $0(){let i=Ea("canvas");return i.style.display="block",i}var Vg={},So=null;function df(...i){let e="THREE."+i.shift();So?So("log",e,...i):console.log(e,...i)}function Y0(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ze(...i){i=Y0(i);let e="THREE."+i.shift();if(So)So("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function tt(...i){i=Y0(i);let e="THREE."+i.shift();if(So)So("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function _a(...i){let e=i.join(" ");e in Vg||(Vg[e]=!0,Ze(...i))}function J0(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Z0={[oc]:oc,[lc]:Mo,[cc]:cc,[bo]:hc,[ac]:ac,[Mo]:lc,[uc]:uc,[hc]:bo},rs=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var cd=Math.PI/180,mc=180/Math.PI;function Wa(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]+"-"+Bn[e&255]+Bn[e>>8&255]+"-"+Bn[e>>16&15|64]+Bn[e>>24&255]+"-"+Bn[t&63|128]+Bn[t>>8&255]+"-"+Bn[t>>16&255]+Bn[t>>24&255]+Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]).toLowerCase()}function yt(i,e,t){return Math.max(e,Math.min(t,i))}function bb(i,e){return(i%e+e)%e}function hd(i,e,t){return(1-t)*i+t*e}function K0(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function ff(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Mb(i,e){if(e.constructor===Float32Array)return i;let t=ff(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Sb(i,e){if(e.constructor===Float32Array)return i;let t=ff(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var xt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Qn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],g=r[o+2],v=r[o+3];if(u!==v||l!==d||c!==f||h!==g){let m=l*d+c*f+h*g+u*v;m<0&&(d=-d,f=-f,g=-g,v=-v,m=-m);let p=1-a;if(m<.9995){let x=Math.acos(m),M=Math.sin(x);p=Math.sin(p*x)/M,a=Math.sin(a*x)/M,l=l*p+d*a,c=c*p+f*a,h=h*p+g*a,u=u*p+v*a}else{l=l*p+d*a,c=c*p+f*a,h=h*p+g*a,u=u*p+v*a;let x=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=x,c*=x,h*=x,u*=x}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+h*u+l*f-c*d,e[t+1]=l*g+h*d+c*u-a*f,e[t+2]=c*g+h*f+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"YXZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"ZXY":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"ZYX":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"YZX":this._x=d*h*u+c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u-d*f*g;break;case"XZY":this._x=d*h*u-c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u+d*f*g;break;default:Ze("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(yt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},W=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Gg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Gg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return ud.copy(this).projectOnVector(e),this.sub(ud)}reflect(e){return this.sub(ud.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(yt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ud=new W,Gg=new Qn,nt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],g=n[8],v=s[0],m=s[3],p=s[6],x=s[1],M=s[4],b=s[7],C=s[2],E=s[5],y=s[8];return r[0]=o*v+a*x+l*C,r[3]=o*m+a*M+l*E,r[6]=o*p+a*b+l*y,r[1]=c*v+h*x+u*C,r[4]=c*m+h*M+u*E,r[7]=c*p+h*b+u*y,r[2]=d*v+f*x+g*C,r[5]=d*m+f*M+g*E,r[8]=d*p+f*b+g*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,g=t*u+n*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/g;return e[0]=u*v,e[1]=(s*c-h*n)*v,e[2]=(a*n-s*o)*v,e[3]=d*v,e[4]=(h*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=f*v,e[7]=(n*l-c*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return _a("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(dd.makeScale(e,t)),this}rotate(e){return _a("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(dd.makeRotation(-e)),this}translate(e,t){return _a("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(dd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},dd=new nt,Hg=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Wg=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function wb(){let i={enabled:!0,workingColorSpace:Ma,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Rt&&(s.r=Ms(s.r),s.g=Ms(s.g),s.b=Ms(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Rt&&(s.r=_o(s.r),s.g=_o(s.g),s.b=_o(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Cs?Sa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ma]:{primaries:e,whitePoint:n,transfer:Sa,toXYZ:Hg,fromXYZ:Wg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:di},outputColorSpaceConfig:{drawingBufferColorSpace:di}},[di]:{primaries:e,whitePoint:n,transfer:Rt,toXYZ:Hg,fromXYZ:Wg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:di}}}),i}var vt=wb();function Ms(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function _o(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var oo,gc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{oo===void 0&&(oo=Ea("canvas")),oo.width=e.width,oo.height=e.height;let s=oo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=oo}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ea("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ms(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Ms(t[n]/255)*255):t[n]=Ms(t[n]);return{data:t,width:e.width,height:e.height}}else return Ze("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Eb=0,wo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Eb++}),this.uuid=Wa(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(fd(s[o].image)):r.push(fd(s[o]))}else r=fd(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function fd(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?gc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ze("Texture: Unable to serialize Texture."),{})}var Tb=0,pd=new W,ei=class i extends rs{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=ss,s=ss,r=Dn,o=Oi,a=Vi,l=gi,c=i.DEFAULT_ANISOTROPY,h=Cs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Tb++}),this.uuid=Wa(),this.name="",this.source=new wo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new xt(0,0),this.repeat=new xt(1,1),this.center=new xt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(pd).x}get height(){return this.source.getSize(pd).y}get depth(){return this.source.getSize(pd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ze(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==jd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case dc:e.x=e.x-Math.floor(e.x);break;case ss:e.x=e.x<0?0:1;break;case fc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case dc:e.y=e.y-Math.floor(e.y);break;case ss:e.y=e.y<0?0:1;break;case fc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=jd;ei.DEFAULT_ANISOTROPY=1;var jt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],g=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-v)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+v)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,b=(f+1)/2,C=(p+1)/2,E=(h+d)/4,y=(u+v)/4,S=(g+m)/4;return M>b&&M>C?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=E/n,r=y/n):b>C?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=E/s,r=S/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=y/r,s=S/r),this.set(n,s,r,t),this}let x=Math.sqrt((m-g)*(m-g)+(u-v)*(u-v)+(d-h)*(d-h));return Math.abs(x)<.001&&(x=1),this.x=(m-g)/x,this.y=(u-v)/x,this.z=(d-h)/x,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=yt(this.x,e.x,t.x),this.y=yt(this.y,e.y,t.y),this.z=yt(this.z,e.z,t.z),this.w=yt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=yt(this.x,e,t),this.y=yt(this.y,e,t),this.z=yt(this.z,e,t),this.w=yt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(yt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},vc=class extends rs{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Dn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new jt(0,0,e,t),this.scissorTest=!1,this.viewport=new jt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Dn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new wo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Kn=class extends vc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Ta=class extends ei{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=ss,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var yc=class extends ei{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=ss,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var zt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,g,v,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,v,m)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,v,m){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=u,p[14]=d,p[3]=f,p[7]=g,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/ao.setFromMatrixColumn(e,0).length(),r=1/ao.setFromMatrixColumn(e,1).length(),o=1/ao.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,g=a*h,v=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+g*c,t[5]=d-v*c,t[9]=-a*l,t[2]=v-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,g=c*h,v=c*u;t[0]=d+v*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-g,t[6]=v+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,g=c*h,v=c*u;t[0]=d-v*a,t[4]=-o*u,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*h,t[9]=v-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,g=a*h,v=a*u;t[0]=l*h,t[4]=g*c-f,t[8]=d*c+v,t[1]=l*u,t[5]=v*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,v=a*c;t[0]=l*h,t[4]=v-d*u,t[8]=g*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+g,t[10]=d-v*u}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,v=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+v,t[5]=o*h,t[9]=f*u-g,t[2]=g*u-f,t[6]=a*h,t[10]=v*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Ab,e,Cb)}lookAt(e,t,n){let s=this.elements;return hi.subVectors(e,t),hi.lengthSq()===0&&(hi.z=1),hi.normalize(),Hs.crossVectors(n,hi),Hs.lengthSq()===0&&(Math.abs(n.z)===1?hi.x+=1e-4:hi.z+=1e-4,hi.normalize(),Hs.crossVectors(n,hi)),Hs.normalize(),Dl.crossVectors(hi,Hs),s[0]=Hs.x,s[4]=Dl.x,s[8]=hi.x,s[1]=Hs.y,s[5]=Dl.y,s[9]=hi.y,s[2]=Hs.z,s[6]=Dl.z,s[10]=hi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],g=n[2],v=n[6],m=n[10],p=n[14],x=n[3],M=n[7],b=n[11],C=n[15],E=s[0],y=s[4],S=s[8],U=s[12],L=s[1],R=s[5],O=s[9],V=s[13],P=s[2],H=s[6],Y=s[10],k=s[14],re=s[3],q=s[7],j=s[11],te=s[15];return r[0]=o*E+a*L+l*P+c*re,r[4]=o*y+a*R+l*H+c*q,r[8]=o*S+a*O+l*Y+c*j,r[12]=o*U+a*V+l*k+c*te,r[1]=h*E+u*L+d*P+f*re,r[5]=h*y+u*R+d*H+f*q,r[9]=h*S+u*O+d*Y+f*j,r[13]=h*U+u*V+d*k+f*te,r[2]=g*E+v*L+m*P+p*re,r[6]=g*y+v*R+m*H+p*q,r[10]=g*S+v*O+m*Y+p*j,r[14]=g*U+v*V+m*k+p*te,r[3]=x*E+M*L+b*P+C*re,r[7]=x*y+M*R+b*H+C*q,r[11]=x*S+M*O+b*Y+C*j,r[15]=x*U+M*V+b*k+C*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],g=e[3],v=e[7],m=e[11],p=e[15],x=l*f-c*d,M=a*f-c*u,b=a*d-l*u,C=o*f-c*h,E=o*d-l*h,y=o*u-a*h;return t*(v*x-m*M+p*b)-n*(g*x-m*C+p*E)+s*(g*M-v*C+p*y)-r*(g*b-v*E+m*y)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],g=e[12],v=e[13],m=e[14],p=e[15],x=t*a-n*o,M=t*l-s*o,b=t*c-r*o,C=n*l-s*a,E=n*c-r*a,y=s*c-r*l,S=h*v-u*g,U=h*m-d*g,L=h*p-f*g,R=u*m-d*v,O=u*p-f*v,V=d*p-f*m,P=x*V-M*O+b*R+C*L-E*U+y*S;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/P;return e[0]=(a*V-l*O+c*R)*H,e[1]=(s*O-n*V-r*R)*H,e[2]=(v*y-m*E+p*C)*H,e[3]=(d*E-u*y-f*C)*H,e[4]=(l*L-o*V-c*U)*H,e[5]=(t*V-s*L+r*U)*H,e[6]=(m*b-g*y-p*M)*H,e[7]=(h*y-d*b+f*M)*H,e[8]=(o*O-a*L+c*S)*H,e[9]=(n*L-t*O-r*S)*H,e[10]=(g*E-v*b+p*x)*H,e[11]=(u*b-h*E-f*x)*H,e[12]=(a*U-o*R-l*S)*H,e[13]=(t*R-n*U+s*S)*H,e[14]=(v*M-g*C-m*x)*H,e[15]=(h*C-u*M+d*x)*H,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,g=r*u,v=o*h,m=o*u,p=a*u,x=l*c,M=l*h,b=l*u,C=n.x,E=n.y,y=n.z;return s[0]=(1-(v+p))*C,s[1]=(f+b)*C,s[2]=(g-M)*C,s[3]=0,s[4]=(f-b)*E,s[5]=(1-(d+p))*E,s[6]=(m+x)*E,s[7]=0,s[8]=(g+M)*y,s[9]=(m-x)*y,s[10]=(1-(d+v))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=ao.set(s[0],s[1],s[2]).length(),a=ao.set(s[4],s[5],s[6]).length(),l=ao.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Di.copy(this);let c=1/o,h=1/a,u=1/l;return Di.elements[0]*=c,Di.elements[1]*=c,Di.elements[2]*=c,Di.elements[4]*=h,Di.elements[5]*=h,Di.elements[6]*=h,Di.elements[8]*=u,Di.elements[9]*=u,Di.elements[10]*=u,t.setFromRotationMatrix(Di),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=wi,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),g,v;if(l)g=r/(o-r),v=o*r/(o-r);else if(a===wi)g=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===wa)g=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=wi,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),g,v;if(l)g=1/(o-r),v=o/(o-r);else if(a===wi)g=-2/(o-r),v=-(o+r)/(o-r);else if(a===wa)g=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},ao=new W,Di=new zt,Ab=new W(0,0,0),Cb=new W(1,1,1),Hs=new W,Dl=new W,hi=new W,Xg=new zt,qg=new Qn,Js=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(yt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-yt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(yt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-yt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(yt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-yt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ze("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Xg.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Xg,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return qg.setFromEuler(this),this.setFromQuaternion(qg,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Js.DEFAULT_ORDER="XYZ";var Aa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Rb=0,$g=new W,lo=new Qn,vs=new zt,Ul=new W,ma=new W,Pb=new W,Ib=new Qn,Yg=new W(1,0,0),Jg=new W(0,1,0),Zg=new W(0,0,1),Kg={type:"added"},Lb={type:"removed"},co={type:"childadded",child:null},md={type:"childremoved",child:null},ti=class i extends rs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Rb++}),this.uuid=Wa(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new W,t=new Js,n=new Qn,s=new W(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new zt},normalMatrix:{value:new nt}}),this.matrix=new zt,this.matrixWorld=new zt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Aa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return lo.setFromAxisAngle(e,t),this.quaternion.multiply(lo),this}rotateOnWorldAxis(e,t){return lo.setFromAxisAngle(e,t),this.quaternion.premultiply(lo),this}rotateX(e){return this.rotateOnAxis(Yg,e)}rotateY(e){return this.rotateOnAxis(Jg,e)}rotateZ(e){return this.rotateOnAxis(Zg,e)}translateOnAxis(e,t){return $g.copy(e).applyQuaternion(this.quaternion),this.position.add($g.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Yg,e)}translateY(e){return this.translateOnAxis(Jg,e)}translateZ(e){return this.translateOnAxis(Zg,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(vs.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Ul.copy(e):Ul.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),ma.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?vs.lookAt(ma,Ul,this.up):vs.lookAt(Ul,ma,this.up),this.quaternion.setFromRotationMatrix(vs),s&&(vs.extractRotation(s.matrixWorld),lo.setFromRotationMatrix(vs),this.quaternion.premultiply(lo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(tt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Kg),co.child=e,this.dispatchEvent(co),co.child=null):tt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Lb),md.child=e,this.dispatchEvent(md),md.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),vs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),vs.multiply(e.parent.matrixWorld)),e.applyMatrix4(vs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Kg),co.child=e,this.dispatchEvent(co),co.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ma,e,Pb),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ma,Ib,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ti.DEFAULT_UP=new W(0,1,0);ti.DEFAULT_MATRIX_AUTO_UPDATE=!0;ti.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var pi=class extends ti{constructor(){super(),this.isGroup=!0,this.type="Group"}},Nb={type:"move"},Eo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new pi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new pi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new pi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let m=t.getJointPose(v,n),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Nb)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new pi;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},j0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ws={h:0,s:0,l:0},Fl={h:0,s:0,l:0};function gd(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var _t=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=di){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,vt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=vt.workingColorSpace){return this.r=e,this.g=t,this.b=n,vt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=vt.workingColorSpace){if(e=bb(e,1),t=yt(t,0,1),n=yt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=gd(o,r,e+1/3),this.g=gd(o,r,e),this.b=gd(o,r,e-1/3)}return vt.colorSpaceToWorking(this,s),this}setStyle(e,t=di){function n(r){r!==void 0&&parseFloat(r)<1&&Ze("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ze("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ze("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=di){let n=j0[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ze("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ms(e.r),this.g=Ms(e.g),this.b=Ms(e.b),this}copyLinearToSRGB(e){return this.r=_o(e.r),this.g=_o(e.g),this.b=_o(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=di){return vt.workingToColorSpace(zn.copy(this),e),Math.round(yt(zn.r*255,0,255))*65536+Math.round(yt(zn.g*255,0,255))*256+Math.round(yt(zn.b*255,0,255))}getHexString(e=di){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=vt.workingColorSpace){vt.workingToColorSpace(zn.copy(this),t);let n=zn.r,s=zn.g,r=zn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=vt.workingColorSpace){return vt.workingToColorSpace(zn.copy(this),t),e.r=zn.r,e.g=zn.g,e.b=zn.b,e}getStyle(e=di){vt.workingToColorSpace(zn.copy(this),e);let t=zn.r,n=zn.g,s=zn.b;return e!==di?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Ws),this.setHSL(Ws.h+e,Ws.s+t,Ws.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Ws),e.getHSL(Fl);let n=hd(Ws.h,Fl.h,t),s=hd(Ws.s,Fl.s,t),r=hd(Ws.l,Fl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},zn=new _t;_t.NAMES=j0;var br=class extends ti{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Js,this.environmentIntensity=1,this.environmentRotation=new Js,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ui=new W,ys=new W,vd=new W,xs=new W,ho=new W,uo=new W,jg=new W,yd=new W,xd=new W,_d=new W,bd=new jt,Md=new jt,Sd=new jt,Ys=class i{constructor(e=new W,t=new W,n=new W){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ui.subVectors(e,t),s.cross(Ui);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ui.subVectors(s,t),ys.subVectors(n,t),vd.subVectors(e,t);let o=Ui.dot(Ui),a=Ui.dot(ys),l=Ui.dot(vd),c=ys.dot(ys),h=ys.dot(vd),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,g=(o*h-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,xs)===null?!1:xs.x>=0&&xs.y>=0&&xs.x+xs.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,xs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,xs.x),l.addScaledVector(o,xs.y),l.addScaledVector(a,xs.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return bd.setScalar(0),Md.setScalar(0),Sd.setScalar(0),bd.fromBufferAttribute(e,t),Md.fromBufferAttribute(e,n),Sd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(bd,r.x),o.addScaledVector(Md,r.y),o.addScaledVector(Sd,r.z),o}static isFrontFacing(e,t,n,s){return Ui.subVectors(n,t),ys.subVectors(e,t),Ui.cross(ys).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ui.subVectors(this.c,this.b),ys.subVectors(this.a,this.b),Ui.cross(ys).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;ho.subVectors(s,n),uo.subVectors(r,n),yd.subVectors(e,n);let l=ho.dot(yd),c=uo.dot(yd);if(l<=0&&c<=0)return t.copy(n);xd.subVectors(e,s);let h=ho.dot(xd),u=uo.dot(xd);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(ho,o);_d.subVectors(e,r);let f=ho.dot(_d),g=uo.dot(_d);if(g>=0&&f<=g)return t.copy(r);let v=f*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(uo,a);let m=h*g-f*u;if(m<=0&&u-h>=0&&f-g>=0)return jg.subVectors(r,s),a=(u-h)/(u-h+(f-g)),t.copy(s).addScaledVector(jg,a);let p=1/(m+v+d);return o=v*p,a=d*p,t.copy(n).addScaledVector(ho,o).addScaledVector(uo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Zs=class{constructor(e=new W(1/0,1/0,1/0),t=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Fi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Fi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Fi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Fi):Fi.fromBufferAttribute(r,o),Fi.applyMatrix4(e.matrixWorld),this.expandByPoint(Fi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ol.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ol.copy(n.boundingBox)),Ol.applyMatrix4(e.matrixWorld),this.union(Ol)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Fi),Fi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ga),kl.subVectors(this.max,ga),fo.subVectors(e.a,ga),po.subVectors(e.b,ga),mo.subVectors(e.c,ga),Xs.subVectors(po,fo),qs.subVectors(mo,po),vr.subVectors(fo,mo);let t=[0,-Xs.z,Xs.y,0,-qs.z,qs.y,0,-vr.z,vr.y,Xs.z,0,-Xs.x,qs.z,0,-qs.x,vr.z,0,-vr.x,-Xs.y,Xs.x,0,-qs.y,qs.x,0,-vr.y,vr.x,0];return!wd(t,fo,po,mo,kl)||(t=[1,0,0,0,1,0,0,0,1],!wd(t,fo,po,mo,kl))?!1:(Bl.crossVectors(Xs,qs),t=[Bl.x,Bl.y,Bl.z],wd(t,fo,po,mo,kl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Fi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Fi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(_s[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),_s[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),_s[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),_s[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),_s[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),_s[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),_s[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),_s[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(_s),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},_s=[new W,new W,new W,new W,new W,new W,new W,new W],Fi=new W,Ol=new Zs,fo=new W,po=new W,mo=new W,Xs=new W,qs=new W,vr=new W,ga=new W,kl=new W,Bl=new W,yr=new W;function wd(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){yr.fromArray(i,r);let a=s.x*Math.abs(yr.x)+s.y*Math.abs(yr.y)+s.z*Math.abs(yr.z),l=e.dot(yr),c=t.dot(yr),h=n.dot(yr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var gn=new W,zl=new xt,Db=0,Vn=class extends rs{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Db++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=q0,this.updateRanges=[],this.gpuType=Bi,this.version=0,this._normalizationScale=e!==void 0?ff(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)zl.fromBufferAttribute(this,t),zl.applyMatrix3(e),this.setXY(t,zl.x,zl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix3(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix4(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.applyNormalMatrix(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)gn.fromBufferAttribute(this,t),gn.transformDirection(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Mb(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Sb(e,this.array)}};var Ca=class extends Vn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Ra=class extends Vn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Kt=class extends Vn{constructor(e,t,n){super(new Float32Array(e),t,n)}},Ub=new Zs,va=new W,Ed=new W,Ks=class{constructor(e=new W,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Ub.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;va.subVectors(e,this.center);let t=va.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(va,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ed.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(va.copy(e.center).add(Ed)),this.expandByPoint(va.copy(e.center).sub(Ed))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Fb=0,Si=new zt,Td=new ti,go=new W,ui=new Zs,ya=new Zs,Pn=new W,Un=class i extends rs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Fb++}),this.uuid=Wa(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(xb(e)?Ra:Ca)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new nt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Si.makeRotationFromQuaternion(e),this.applyMatrix4(Si),this}rotateX(e){return Si.makeRotationX(e),this.applyMatrix4(Si),this}rotateY(e){return Si.makeRotationY(e),this.applyMatrix4(Si),this}rotateZ(e){return Si.makeRotationZ(e),this.applyMatrix4(Si),this}translate(e,t,n){return Si.makeTranslation(e,t,n),this.applyMatrix4(Si),this}scale(e,t,n){return Si.makeScale(e,t,n),this.applyMatrix4(Si),this}lookAt(e){return Td.lookAt(e),Td.updateMatrix(),this.applyMatrix4(Td.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(go).negate(),this.translate(go.x,go.y,go.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Kt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ze("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Zs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];ui.setFromBufferAttribute(r),this.morphTargetsRelative?(Pn.addVectors(this.boundingBox.min,ui.min),this.boundingBox.expandByPoint(Pn),Pn.addVectors(this.boundingBox.max,ui.max),this.boundingBox.expandByPoint(Pn)):(this.boundingBox.expandByPoint(ui.min),this.boundingBox.expandByPoint(ui.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&tt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ks);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(e){let n=this.boundingSphere.center;if(ui.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ya.setFromBufferAttribute(a),this.morphTargetsRelative?(Pn.addVectors(ui.min,ya.min),ui.expandByPoint(Pn),Pn.addVectors(ui.max,ya.max),ui.expandByPoint(Pn)):(ui.expandByPoint(ya.min),ui.expandByPoint(ya.max))}ui.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Pn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Pn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Pn.fromBufferAttribute(a,c),l&&(go.fromBufferAttribute(e,c),Pn.add(go)),s=Math.max(s,n.distanceToSquared(Pn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&tt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){tt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Vn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let U=0;U<n.count;U++)a[U]=new W,l[U]=new W;let h=new W,u=new W,d=new W,f=new xt,g=new xt,v=new xt,m=new W,p=new W;function x(U,L,R){c[U]=c[L]=c[R]=1,h.fromBufferAttribute(n,U),u.fromBufferAttribute(n,L),d.fromBufferAttribute(n,R),f.fromBufferAttribute(r,U),g.fromBufferAttribute(r,L),v.fromBufferAttribute(r,R),u.sub(h),d.sub(h),g.sub(f),v.sub(f);let O=1/(g.x*v.y-v.x*g.y);isFinite(O)&&(m.copy(u).multiplyScalar(v.y).addScaledVector(d,-g.y).multiplyScalar(O),p.copy(d).multiplyScalar(g.x).addScaledVector(u,-v.x).multiplyScalar(O),a[U].add(m),a[L].add(m),a[R].add(m),l[U].add(p),l[L].add(p),l[R].add(p))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let U=0,L=M.length;U<L;++U){let R=M[U],O=R.start,V=R.count;for(let P=O,H=O+V;P<H;P+=3)x(e.getX(P+0),e.getX(P+1),e.getX(P+2))}let b=new W,C=new W,E=new W,y=new W;function S(U){E.fromBufferAttribute(s,U),y.copy(E);let L=a[U];b.copy(L),b.sub(E.multiplyScalar(E.dot(L))).normalize(),C.crossVectors(y,L);let O=C.dot(l[U])<0?-1:1;o.setXYZW(U,b.x,b.y,b.z,O)}for(let U=0,L=n.count;U<L;++U)c[U]&&S(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Vn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new W,r=new W,o=new W,a=new W,l=new W,c=new W,h=new W,u=new W;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),v=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Pn.fromBufferAttribute(e,t),Pn.normalize(),e.setXYZ(t,Pn.x,Pn.y,Pn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,g=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*h;for(let p=0;p<h;p++)d[g++]=c[f++]}return new Vn(d,h,u)}if(this.index===null)return Ze("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ad=new W,Ob=new W,kb=new nt,fi=class{constructor(e=new W(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Ad.subVectors(n,t).cross(Ob.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Ad),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||kb.getNormalMatrix(e),s=this.coplanarPoint(Ad).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Bb=0,ws=class extends rs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Bb++}),this.uuid=Wa(),this.name="",this.type="Material",this.blending=Do,this.side=nr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Gd,this.blendDst=Hd,this.blendEquation=Er,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new _t(0,0,0),this.blendAlpha=0,this.depthFunc=bo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=z0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=rc,this.stencilZFail=rc,this.stencilZPass=rc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ze(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new _t().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new fi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new xt().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new xt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var bs=new W,Cd=new W,Vl=new W,Gl=new W,js=class{constructor(e=new W,t=new W(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,bs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=bs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(bs.copy(this.origin).addScaledVector(this.direction,t),bs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Cd.copy(e).add(t).multiplyScalar(.5),Vl.copy(t).sub(e).normalize(),Gl.copy(this.origin).sub(Cd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Vl),a=Gl.dot(this.direction),l=-Gl.dot(Vl),c=Gl.lengthSq(),h=Math.abs(1-o*o),u,d,f,g;if(h>0)if(u=o*l-a,d=o*a-l,g=r*h,u>=0)if(d>=-g)if(d<=g){let v=1/h;u*=v,d*=v,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Cd).addScaledVector(Vl,d),f}intersectSphere(e,t){if(e.radius<0)return null;bs.subVectors(e.center,this.origin);let n=bs.dot(this.direction),s=bs.dot(bs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,bs)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,g=t.x-o.x,v=t.y-o.y,m=t.z-o.z,p=n.x-o.x,x=n.y-o.y,M=n.z-o.z,b=Math.abs(l),C=Math.abs(c),E=Math.abs(h),y,S,U,L,R,O,V,P,H,Y,k,re;if(b>=C&&b>=E?(U=l,O=u,H=g,re=p,l>=0?(y=c,S=h,L=d,R=f,V=v,P=m,Y=x,k=M):(y=h,S=c,L=f,R=d,V=m,P=v,Y=M,k=x)):C>=E?(U=c,O=d,H=v,re=x,c>=0?(y=h,S=l,L=f,R=u,V=m,P=g,Y=M,k=p):(y=l,S=h,L=u,R=f,V=g,P=m,Y=p,k=M)):(U=h,O=f,H=m,re=M,h>=0?(y=l,S=c,L=u,R=d,V=g,P=v,Y=p,k=x):(y=c,S=l,L=d,R=u,V=v,P=g,Y=x,k=p)),U===0)return null;let q=y/U,j=S/U,te=1/U,de=L-q*O,ue=R-j*O,ee=V-q*H,me=P-j*H,ye=Y-q*re,Ae=k-j*re,Me=ye*me-Ae*ee,Xe=de*Ae-ue*ye,rt=ee*ue-me*de;if(s){if(Me<0||Xe<0||rt<0)return null}else if((Me<0||Xe<0||rt<0)&&(Me>0||Xe>0||rt>0))return null;let Ge=Me+Xe+rt;if(Ge===0)return null;let ut=te*(Me*O+Xe*H+rt*re);return(Ge>0?ut<0:ut>0)?null:this.at(ut/Ge,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},xc=class extends ws{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new _t(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Js,this.combine=Wd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Qg=new zt,xr=new js,Hl=new Ks,e0=new W,Wl=new W,Xl=new W,ql=new W,Rd=new W,$l=new W,t0=new W,Yl=new W,ln=class extends ti{constructor(e=new Un,t=new xc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){$l.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Rd.fromBufferAttribute(u,e),o?$l.addScaledVector(Rd,h):$l.addScaledVector(Rd.sub(t),h))}t.add($l)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Hl.copy(n.boundingSphere),Hl.applyMatrix4(r),xr.copy(e.ray).recast(e.near),!(Hl.containsPoint(xr.origin)===!1&&(xr.intersectSphere(Hl,e0)===null||xr.origin.distanceToSquared(e0)>(e.far-e.near)**2))&&(Qg.copy(r).invert(),xr.copy(e.ray).applyMatrix4(Qg),!(n.boundingBox!==null&&xr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,xr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=d.length;g<v;g++){let m=d[g],p=o[m.materialIndex],x=Math.max(m.start,f.start),M=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=x,C=M;b<C;b+=3){let E=a.getX(b),y=a.getX(b+1),S=a.getX(b+2);s=Jl(this,p,e,n,c,h,u,E,y,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let m=g,p=v;m<p;m+=3){let x=a.getX(m),M=a.getX(m+1),b=a.getX(m+2);s=Jl(this,o,e,n,c,h,u,x,M,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=d.length;g<v;g++){let m=d[g],p=o[m.materialIndex],x=Math.max(m.start,f.start),M=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=x,C=M;b<C;b+=3){let E=b,y=b+1,S=b+2;s=Jl(this,p,e,n,c,h,u,E,y,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let m=g,p=v;m<p;m+=3){let x=m,M=m+1,b=m+2;s=Jl(this,o,e,n,c,h,u,x,M,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function zb(i,e,t,n,s,r,o,a){let l;if(e.side===jn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===nr,a),l===null)return null;Yl.copy(a),Yl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Yl);return c<t.near||c>t.far?null:{distance:c,point:Yl.clone(),object:i}}function Jl(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Wl),i.getVertexPosition(l,Xl),i.getVertexPosition(c,ql);let h=zb(i,e,t,n,Wl,Xl,ql,t0);if(h){let u=new W;Ys.getBarycoord(t0,Wl,Xl,ql,u),s&&(h.uv=Ys.getInterpolatedAttribute(s,a,l,c,u,new xt)),r&&(h.uv1=Ys.getInterpolatedAttribute(r,a,l,c,u,new xt)),o&&(h.normal=Ys.getInterpolatedAttribute(o,a,l,c,u,new W),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new W,materialIndex:0};Ys.getNormal(Wl,Xl,ql,d.normal),h.face=d,h.barycoord=u}return h}var _c=class extends ei{constructor(e=null,t=1,n=1,s,r,o,a,l,c=In,h=In,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var _r=new Ks,Vb=new xt(.5,.5),Zl=new W,Mr=class{constructor(e=new fi,t=new fi,n=new fi,s=new fi,r=new fi,o=new fi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=wi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],g=r[8],v=r[9],m=r[10],p=r[11],x=r[12],M=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-o,f-h,p-g,C-x).normalize(),s[1].setComponents(c+o,f+h,p+g,C+x).normalize(),s[2].setComponents(c+a,f+u,p+v,C+M).normalize(),s[3].setComponents(c-a,f-u,p-v,C-M).normalize(),n)s[4].setComponents(l,d,m,b).normalize(),s[5].setComponents(c-l,f-d,p-m,C-b).normalize();else if(s[4].setComponents(c-l,f-d,p-m,C-b).normalize(),t===wi)s[5].setComponents(c+l,f+d,p+m,C+b).normalize();else if(t===wa)s[5].setComponents(l,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),_r.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),_r.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(_r)}intersectsSprite(e){_r.center.set(0,0,0);let t=Vb.distanceTo(e.center);return _r.radius=.7071067811865476+t,_r.applyMatrix4(e.matrixWorld),this.intersectsSphere(_r)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Zl.x=s.normal.x>0?e.max.x:e.min.x,Zl.y=s.normal.y>0?e.max.y:e.min.y,Zl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Zl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},n0=new zt,bc=class i{constructor(){this.coordinateSystem=wi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];n0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Mr),n[s].setFromProjectionMatrix(n0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Mr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Mc=class extends ws{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new _t(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Sc=new W,wc=new W,i0=new zt,xa=new js,Kl=new Ks,Pd=new W,s0=new W,Ec=class extends ti{constructor(e=new Un,t=new Mc){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Sc.fromBufferAttribute(t,s-1),wc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Sc.distanceTo(wc);e.setAttribute("lineDistance",new Kt(n,1))}else Ze("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Kl.copy(n.boundingSphere),Kl.applyMatrix4(s),Kl.radius+=r,e.ray.intersectsSphere(Kl)===!1)return;i0.copy(s).invert(),xa.copy(e.ray).applyMatrix4(i0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let v=f,m=g-1;v<m;v+=c){let p=h.getX(v),x=h.getX(v+1),M=jl(this,e,xa,l,p,x,v);M&&t.push(M)}if(this.isLineLoop){let v=h.getX(g-1),m=h.getX(f),p=jl(this,e,xa,l,v,m,g-1);p&&t.push(p)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let v=f,m=g-1;v<m;v+=c){let p=jl(this,e,xa,l,v,v+1,v);p&&t.push(p)}if(this.isLineLoop){let v=jl(this,e,xa,l,g-1,f,g-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function jl(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Sc.fromBufferAttribute(a,s),wc.fromBufferAttribute(a,r),t.distanceSqToSegment(Sc,wc,Pd,s0)>n)return;Pd.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Pd);if(!(c<e.near||c>e.far))return{distance:c,point:s0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var r0=new W,o0=new W,To=class extends Ec{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)r0.fromBufferAttribute(t,s),o0.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+r0.distanceTo(o0);e.setAttribute("lineDistance",new Kt(n,1))}else Ze("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Tc=class extends ws{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new _t(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},a0=new zt,Ud=new js,Ql=new Ks,ec=new W,Ao=class extends ti{constructor(e=new Un,t=new Tc){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ql.copy(n.boundingSphere),Ql.applyMatrix4(s),Ql.radius+=r,e.ray.intersectsSphere(Ql)===!1)return;a0.copy(s).invert(),Ud.copy(e.ray).applyMatrix4(a0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let g=d,v=f;g<v;g++){let m=c.getX(g);ec.fromBufferAttribute(u,m),l0(ec,m,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let g=d,v=f;g<v;g++)ec.fromBufferAttribute(u,g),l0(ec,g,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function l0(i,e,t,n,s,r,o){let a=Ud.distanceSqToPoint(i);if(a<t){let l=new W;Ud.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Pa=class extends ei{constructor(e=[],t=Tr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Es=class extends ei{constructor(e,t,n=ki,s,r,o,a=In,l=In,c,h=Ss,u=1){if(h!==Ss&&h!==As)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new wo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ia=class extends Es{constructor(e,t=ki,n=Tr,s,r,o=In,a=In,l,c=Ss){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},La=class extends ei{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Co=class i extends Un{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Kt(c,3)),this.setAttribute("normal",new Kt(h,3)),this.setAttribute("uv",new Kt(u,2));function g(v,m,p,x,M,b,C,E,y,S,U){let L=b/y,R=C/S,O=b/2,V=C/2,P=E/2,H=y+1,Y=S+1,k=0,re=0,q=new W;for(let j=0;j<Y;j++){let te=j*R-V;for(let de=0;de<H;de++){let ue=de*L-O;q[v]=ue*x,q[m]=te*M,q[p]=P,c.push(q.x,q.y,q.z),q[v]=0,q[m]=0,q[p]=E>0?1:-1,h.push(q.x,q.y,q.z),u.push(de/y),u.push(1-j/S),k+=1}}for(let j=0;j<S;j++)for(let te=0;te<y;te++){let de=d+te+H*j,ue=d+te+H*(j+1),ee=d+(te+1)+H*(j+1),me=d+(te+1)+H*j;l.push(de,ue,me),l.push(ue,ee,me),re+=6}a.addGroup(f,re,U),f+=re,d+=k}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Ro=class i extends Un{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],g=0,v=[],m=n/2,p=0;x(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(h),this.setAttribute("position",new Kt(u,3)),this.setAttribute("normal",new Kt(d,3)),this.setAttribute("uv",new Kt(f,2));function x(){let b=new W,C=new W,E=0,y=(t-e)/n;for(let S=0;S<=r;S++){let U=[],L=S/r,R=L*(t-e)+e;for(let O=0;O<=s;O++){let V=O/s,P=V*l+a,H=Math.sin(P),Y=Math.cos(P);C.x=R*H,C.y=-L*n+m,C.z=R*Y,u.push(C.x,C.y,C.z),b.set(H,y,Y).normalize(),d.push(b.x,b.y,b.z),f.push(V,1-L),U.push(g++)}v.push(U)}for(let S=0;S<s;S++)for(let U=0;U<r;U++){let L=v[U][S],R=v[U+1][S],O=v[U+1][S+1],V=v[U][S+1];(e>0||U!==0)&&(h.push(L,R,V),E+=3),(t>0||U!==r-1)&&(h.push(R,O,V),E+=3)}c.addGroup(p,E,0),p+=E}function M(b){let C=g,E=new xt,y=new W,S=0,U=b===!0?e:t,L=b===!0?1:-1;for(let O=1;O<=s;O++)u.push(0,m*L,0),d.push(0,L,0),f.push(.5,.5),g++;let R=g;for(let O=0;O<=s;O++){let P=O/s*l+a,H=Math.cos(P),Y=Math.sin(P);y.x=U*Y,y.y=m*L,y.z=U*H,u.push(y.x,y.y,y.z),d.push(0,L,0),E.x=H*.5+.5,E.y=Y*.5*L+.5,f.push(E.x,E.y),g++}for(let O=0;O<s;O++){let V=C+O,P=R+O;b===!0?h.push(P,P+1,V):h.push(P+1,P,V),S+=3}c.addGroup(p,S,b===!0?1:2),p+=S}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Na=class i extends Ro{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Sr=class i extends Un{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],g=[],v=[],m=[];for(let p=0;p<h;p++){let x=p*d-o;for(let M=0;M<c;M++){let b=M*u-r;g.push(b,-x,0),v.push(0,0,1),m.push(M/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let x=0;x<a;x++){let M=x+c*p,b=x+c*(p+1),C=x+1+c*(p+1),E=x+1+c*p;f.push(M,b,E),f.push(b,C,E)}this.setIndex(f),this.setAttribute("position",new Kt(g,3)),this.setAttribute("normal",new Kt(v,3)),this.setAttribute("uv",new Kt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ts=class i extends Un{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new W,d=new W,f=[],g=[],v=[],m=[];for(let p=0;p<=n;p++){let x=[],M=p/n,b=o+M*a,C=e*Math.cos(b),E=Math.sqrt(e*e-C*C),y=0;p===0&&o===0?y=.5/t:p===n&&l===Math.PI&&(y=-.5/t);for(let S=0;S<=t;S++){let U=S/t,L=s+U*r;u.x=-E*Math.cos(L),u.y=C,u.z=E*Math.sin(L),g.push(u.x,u.y,u.z),d.copy(u).normalize(),v.push(d.x,d.y,d.z),m.push(U+y,1-M),x.push(c++)}h.push(x)}for(let p=0;p<n;p++)for(let x=0;x<t;x++){let M=h[p][x+1],b=h[p][x],C=h[p+1][x],E=h[p+1][x+1];(p!==0||o>0)&&f.push(M,b,E),(p!==n-1||l<Math.PI)&&f.push(b,C,E)}this.setIndex(f),this.setAttribute("position",new Kt(g,3)),this.setAttribute("normal",new Kt(v,3)),this.setAttribute("uv",new Kt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Po=class i extends Un{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],u=[],d=new W,f=new W,g=new W;for(let v=0;v<=n;v++){let m=o+v/n*a;for(let p=0;p<=s;p++){let x=p/s*r;f.x=(e+t*Math.cos(m))*Math.cos(x),f.y=(e+t*Math.cos(m))*Math.sin(x),f.z=t*Math.sin(m),c.push(f.x,f.y,f.z),d.x=e*Math.cos(x),d.y=e*Math.sin(x),g.subVectors(f,d).normalize(),h.push(g.x,g.y,g.z),u.push(p/s),u.push(v/n)}}for(let v=1;v<=n;v++)for(let m=1;m<=s;m++){let p=(s+1)*v+m-1,x=(s+1)*(v-1)+m-1,M=(s+1)*(v-1)+m,b=(s+1)*v+m;l.push(p,x,b),l.push(x,M,b)}this.setIndex(l),this.setAttribute("position",new Kt(c,3)),this.setAttribute("normal",new Kt(h,3)),this.setAttribute("uv",new Kt(u,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function Cr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(c0(s))s.isRenderTargetTexture?(Ze("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(c0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Gn(i){let e={};for(let t=0;t<i.length;t++){let n=Cr(i[t]);for(let s in n)e[s]=n[s]}return e}function c0(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Gb(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function pf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:vt.workingColorSpace}var Q0={clone:Cr,merge:Gn},Hb=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Wb=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Fn=class extends ws{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Hb,this.fragmentShader=Wb,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Cr(e.uniforms),this.uniformsGroups=Gb(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new _t().setHex(s.value);break;case"v2":this.uniforms[n].value=new xt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new W().fromArray(s.value);break;case"v4":this.uniforms[n].value=new jt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new zt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Ac=class extends Fn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Cc=class extends ws{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=k0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Rc=class extends ws{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function vo(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function tc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Qs=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Pc=class extends Qs{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ld,endingEnd:Ld}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Nd:r=e,a=2*t-n;break;case Dd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Nd:o=e,l=2*n-t;break;case Dd:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),v=g*g,m=v*g,p=-d*m+2*d*v-d*g,x=(1+d)*m+(-1.5-2*d)*v+(-.5+d)*g+1,M=(-1-f)*m+(1.5+f)*v+.5*g,b=f*m-f*v;for(let C=0;C!==a;++C)r[C]=p*o[h+C]+x*o[c+C]+M*o[l+C]+b*o[u+C];return r}},Ic=class extends Qs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Lc=class extends Qs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Nc=class extends Qs{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-t)/(s-t),v=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*v+o[l+m]*g;return r}let d=a*2,f=e-1;for(let g=0;g!==a;++g){let v=o[c+g],m=o[l+g],p=f*d+g*2,x=u[p],M=u[p+1],b=e*d+g*2,C=h[b],E=h[b+1],y=qb(n,t,x,C,s);r[g]=ev(y,v,M,E,m)}return r}};function ev(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function Xb(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function qb(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=ev(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=Xb(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var mi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=vo(t,this.TimeBufferType),this.values=vo(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:vo(e.times,Array),values:vo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),tc(e.settings)&&(n.settings={inTangents:vo(e.settings.inTangents,Array),outTangents:vo(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Lc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Ic(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Pc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Nc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ba:t=this.InterpolantFactoryMethodDiscrete;break;case pc:t=this.InterpolantFactoryMethodLinear;break;case sc:t=this.InterpolantFactoryMethodSmooth;break;case Id:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ze("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ba;case this.InterpolantFactoryMethodLinear:return pc;case this.InterpolantFactoryMethodSmooth:return sc;case this.InterpolantFactoryMethodBezier:return Id}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;tc(this.settings)&&(h0(this.settings.inTangents,e),h0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;tc(this.settings)&&(u0(this.settings.inTangents,e),u0(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(tt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(tt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){tt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){tt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&_b(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){tt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===sc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let g=0;g!==n;++g){let v=t[u+g];if(v!==t[d+g]||v!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,tc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function h0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function u0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}mi.prototype.ValueTypeName="";mi.prototype.TimeBufferType=Float32Array;mi.prototype.ValueBufferType=Float32Array;mi.prototype.DefaultInterpolation=pc;var er=class extends mi{constructor(e,t,n){super(e,t,n)}};er.prototype.ValueTypeName="bool";er.prototype.ValueBufferType=Array;er.prototype.DefaultInterpolation=ba;er.prototype.InterpolantFactoryMethodLinear=void 0;er.prototype.InterpolantFactoryMethodSmooth=void 0;var Dc=class extends mi{constructor(e,t,n,s){super(e,t,n,s)}};Dc.prototype.ValueTypeName="color";var Uc=class extends mi{constructor(e,t,n,s){super(e,t,n,s)}};Uc.prototype.ValueTypeName="number";var Fc=class extends Qs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)Qn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Da=class extends mi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Fc(this.times,this.values,this.getValueSize(),e)}};Da.prototype.ValueTypeName="quaternion";Da.prototype.InterpolantFactoryMethodSmooth=void 0;var tr=class extends mi{constructor(e,t,n){super(e,t,n)}};tr.prototype.ValueTypeName="string";tr.prototype.ValueBufferType=Array;tr.prototype.DefaultInterpolation=ba;tr.prototype.InterpolantFactoryMethodLinear=void 0;tr.prototype.InterpolantFactoryMethodSmooth=void 0;var Oc=class extends mi{constructor(e,t,n,s){super(e,t,n,s)}};Oc.prototype.ValueTypeName="vector";var kc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],g=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},tv=new kc,Bc=class{constructor(e){this.manager=e!==void 0?e:tv,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Bc.DEFAULT_MATERIAL_NAME="__DEFAULT";var nc=new W,ic=new Qn,is=new W,Ua=class extends ti{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new zt,this.projectionMatrix=new zt,this.projectionMatrixInverse=new zt,this.coordinateSystem=wi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(nc,ic,is),is.x===1&&is.y===1&&is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(nc,ic,is.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(nc,ic,is),is.x===1&&is.y===1&&is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(nc,ic,is.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},$s=new W,d0=new xt,f0=new xt,Zn=class extends Ua{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=mc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(cd*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return mc*2*Math.atan(Math.tan(cd*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){$s.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set($s.x,$s.y).multiplyScalar(-e/$s.z),$s.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set($s.x,$s.y).multiplyScalar(-e/$s.z)}getViewSize(e,t){return this.getViewBounds(e,d0,f0),t.subVectors(f0,d0)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(cd*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Io=class extends Ua{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var yo=-90,xo=1,Lo=class extends ti{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Zn(yo,xo,e,t);s.layers=this.layers,this.add(s);let r=new Zn(yo,xo,e,t);r.layers=this.layers,this.add(r);let o=new Zn(yo,xo,e,t);o.layers=this.layers,this.add(o);let a=new Zn(yo,xo,e,t);a.layers=this.layers,this.add(a);let l=new Zn(yo,xo,e,t);l.layers=this.layers,this.add(l);let c=new Zn(yo,xo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===wi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===wa)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=v,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},zc=class extends Zn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var mf="\\[\\]\\.:\\/",$b=new RegExp("["+mf+"]","g"),gf="[^"+mf+"]",Yb="[^"+mf.replace("\\.","")+"]",Jb=/((?:WC+[\/:])*)/.source.replace("WC",gf),Zb=/(WCOD+)?/.source.replace("WCOD",Yb),Kb=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",gf),jb=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",gf),Qb=new RegExp("^"+Jb+Zb+Kb+jb+"$"),eM=["material","materials","bones","map"],Fd=class{constructor(e,t,n){let s=n||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},qt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace($b,"")}static parseTrackName(e){let t=Qb.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);eM.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ze("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){tt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){tt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){tt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){tt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){tt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;tt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=Fd;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var EC=new Float32Array(1);var Od=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};function vf(i,e,t,n){let s=tM(n);switch(t){case sf:return i*e;case of:return i*e/s.components*s.byteLength;case $c:return i*e/s.components*s.byteLength;case ir:return i*e*2/s.components*s.byteLength;case Yc:return i*e*2/s.components*s.byteLength;case rf:return i*e*3/s.components*s.byteLength;case Vi:return i*e*4/s.components*s.byteLength;case Jc:return i*e*4/s.components*s.byteLength;case ka:case Ba:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case za:case Va:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Kc:case Qc:return Math.max(i,16)*Math.max(e,8)/4;case Zc:case jc:return Math.max(i,8)*Math.max(e,8)/2;case eh:case th:case ih:case sh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case nh:case Ga:case rh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case oh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ah:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case lh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case ch:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case hh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case uh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case dh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case fh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case ph:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case mh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case gh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case vh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case yh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case xh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case _h:case bh:case Mh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Sh:case wh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Ha:case Eh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function tM(i){switch(i){case gi:case Qd:return{byteLength:1,components:1};case Fo:case ef:case zi:return{byteLength:2,components:1};case Xc:case qc:return{byteLength:2,components:4};case ki:case Wc:case Bi:return{byteLength:4,components:1};case tf:case nf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ze("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Sv(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function iM(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<u.length;f++){let g=u[d],v=u[f];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++d,u[d]=v)}u.length=d+1;for(let f=0,g=u.length;f<g;f++){let v=u[f];i.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var sM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,rM=`#ifdef USE_ALPHAHASH
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
#endif`,oM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,aM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,lM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,cM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,hM=`#ifdef USE_AOMAP
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
#endif`,uM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,dM=`#ifdef USE_BATCHING
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
#endif`,fM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,pM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,mM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,gM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,vM=`#ifdef USE_IRIDESCENCE
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
#endif`,yM=`#ifdef USE_BUMPMAP
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
#endif`,xM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,_M=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,bM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,MM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,SM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,wM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,EM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,TM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,AM=`#define PI 3.141592653589793
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
} // validated`,CM=`vec3 transformedNormal = objectNormal;
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
#endif`,RM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,PM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,IM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,LM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,NM="gl_FragColor = linearToOutputTexel( gl_FragColor );",DM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,UM=`#ifdef USE_ENVMAP
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
#endif`,FM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,OM=`#ifdef USE_ENVMAP
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
#endif`,kM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,BM=`#ifdef USE_ENVMAP
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
#endif`,zM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,VM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,GM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,HM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,WM=`#ifdef USE_GRADIENTMAP
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
}`,XM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,qM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,$M=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,YM=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,JM=`#ifdef USE_ENVMAP
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
#endif`,ZM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,KM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,jM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,QM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,eS=`PhysicalMaterial material;
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
#endif`,tS=`uniform sampler2D dfgLUT;
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
}`,nS=`
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
#endif`,iS=`#if defined( RE_IndirectDiffuse )
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
#endif`,sS=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,rS=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,oS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,aS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,lS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,cS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,hS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,uS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,dS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,fS=`#if defined( USE_POINTS_UV )
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
#endif`,pS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,mS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,gS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,vS=`#if defined( USE_MORPHCOLORS )
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
#endif`,yS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,xS=`#ifdef USE_MORPHTARGETS
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
#endif`,_S=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,bS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,MS=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,SS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,wS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ES=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,TS=`#ifdef USE_NORMALMAP
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
#endif`,AS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,CS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,RS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,PS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,IS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,LS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,NS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,DS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,US=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,FS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,OS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,kS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,BS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,zS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,VS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,GS=`float getShadowMask() {
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
}`,HS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,WS=`#ifdef USE_SKINNING
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
#endif`,XS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,qS=`#ifdef USE_SKINNING
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
#endif`,$S=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,YS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,JS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,ZS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,KS=`#ifdef USE_TRANSMISSION
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
#endif`,jS=`#ifdef USE_TRANSMISSION
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
#endif`,QS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,ew=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,tw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,nw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,iw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,sw=`uniform sampler2D t2D;
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
}`,rw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ow=`uniform float backgroundBlurriness;
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
}`,aw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,lw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cw=`#include <common>
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
}`,hw=`#if DEPTH_PACKING == 3200
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
}`,uw=`#define DISTANCE
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
}`,dw=`#define DISTANCE
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
}`,fw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,pw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,mw=`uniform float scale;
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
}`,gw=`uniform vec3 diffuse;
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
}`,vw=`#include <common>
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
}`,yw=`uniform vec3 diffuse;
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
}`,xw=`#define LAMBERT
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
}`,_w=`#define LAMBERT
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
}`,bw=`#define MATCAP
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
}`,Mw=`#define MATCAP
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
}`,Sw=`#define NORMAL
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
}`,ww=`#define NORMAL
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
}`,Ew=`#define PHONG
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
}`,Tw=`#define PHONG
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
}`,Aw=`#define STANDARD
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
}`,Cw=`#define STANDARD
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
}`,Rw=`#define TOON
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
}`,Pw=`#define TOON
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
}`,Iw=`uniform float size;
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
}`,Lw=`uniform vec3 diffuse;
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
}`,Nw=`#include <common>
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
}`,Dw=`uniform vec3 color;
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
}`,Uw=`uniform float rotation;
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
}`,Fw=`uniform vec3 diffuse;
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
}`,ht={alphahash_fragment:sM,alphahash_pars_fragment:rM,alphamap_fragment:oM,alphamap_pars_fragment:aM,alphatest_fragment:lM,alphatest_pars_fragment:cM,aomap_fragment:hM,aomap_pars_fragment:uM,batching_pars_vertex:dM,batching_vertex:fM,begin_vertex:pM,beginnormal_vertex:mM,bsdfs:gM,iridescence_fragment:vM,bumpmap_pars_fragment:yM,clipping_planes_fragment:xM,clipping_planes_pars_fragment:_M,clipping_planes_pars_vertex:bM,clipping_planes_vertex:MM,color_fragment:SM,color_pars_fragment:wM,color_pars_vertex:EM,color_vertex:TM,common:AM,defaultnormal_vertex:CM,displacementmap_pars_vertex:RM,displacementmap_vertex:PM,emissivemap_fragment:IM,emissivemap_pars_fragment:LM,colorspace_fragment:NM,colorspace_pars_fragment:DM,envmap_fragment:UM,envmap_common_pars_fragment:FM,envmap_pars_fragment:OM,envmap_pars_vertex:kM,envmap_physical_pars_fragment:JM,envmap_vertex:BM,fog_vertex:zM,fog_pars_vertex:VM,fog_fragment:GM,fog_pars_fragment:HM,gradientmap_pars_fragment:WM,lightmap_pars_fragment:XM,lights_lambert_fragment:qM,lights_lambert_pars_fragment:$M,lights_pars_begin:YM,lights_toon_fragment:ZM,lights_toon_pars_fragment:KM,lights_phong_fragment:jM,lights_phong_pars_fragment:QM,lights_physical_fragment:eS,lights_physical_pars_fragment:tS,lights_fragment_begin:nS,lights_fragment_maps:iS,lights_fragment_end:sS,lightprobes_pars_fragment:rS,logdepthbuf_fragment:oS,logdepthbuf_pars_fragment:aS,logdepthbuf_pars_vertex:lS,logdepthbuf_vertex:cS,map_fragment:hS,map_pars_fragment:uS,map_particle_fragment:dS,map_particle_pars_fragment:fS,metalnessmap_fragment:pS,metalnessmap_pars_fragment:mS,morphinstance_vertex:gS,morphcolor_vertex:vS,morphnormal_vertex:yS,morphtarget_pars_vertex:xS,morphtarget_vertex:_S,normal_fragment_begin:bS,normal_fragment_maps:MS,normal_pars_fragment:SS,normal_pars_vertex:wS,normal_vertex:ES,normalmap_pars_fragment:TS,clearcoat_normal_fragment_begin:AS,clearcoat_normal_fragment_maps:CS,clearcoat_pars_fragment:RS,iridescence_pars_fragment:PS,opaque_fragment:IS,packing:LS,premultiplied_alpha_fragment:NS,project_vertex:DS,dithering_fragment:US,dithering_pars_fragment:FS,roughnessmap_fragment:OS,roughnessmap_pars_fragment:kS,shadowmap_pars_fragment:BS,shadowmap_pars_vertex:zS,shadowmap_vertex:VS,shadowmask_pars_fragment:GS,skinbase_vertex:HS,skinning_pars_vertex:WS,skinning_vertex:XS,skinnormal_vertex:qS,specularmap_fragment:$S,specularmap_pars_fragment:YS,tonemapping_fragment:JS,tonemapping_pars_fragment:ZS,transmission_fragment:KS,transmission_pars_fragment:jS,uv_pars_fragment:QS,uv_pars_vertex:ew,uv_vertex:tw,worldpos_vertex:nw,background_vert:iw,background_frag:sw,backgroundCube_vert:rw,backgroundCube_frag:ow,cube_vert:aw,cube_frag:lw,depth_vert:cw,depth_frag:hw,distance_vert:uw,distance_frag:dw,equirect_vert:fw,equirect_frag:pw,linedashed_vert:mw,linedashed_frag:gw,meshbasic_vert:vw,meshbasic_frag:yw,meshlambert_vert:xw,meshlambert_frag:_w,meshmatcap_vert:bw,meshmatcap_frag:Mw,meshnormal_vert:Sw,meshnormal_frag:ww,meshphong_vert:Ew,meshphong_frag:Tw,meshphysical_vert:Aw,meshphysical_frag:Cw,meshtoon_vert:Rw,meshtoon_frag:Pw,points_vert:Iw,points_frag:Lw,shadow_vert:Nw,shadow_frag:Dw,sprite_vert:Uw,sprite_frag:Fw},Le={common:{diffuse:{value:new _t(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new xt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new _t(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new _t(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new _t(16777215)},opacity:{value:1},center:{value:new xt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},cs={basic:{uniforms:Gn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:Gn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new _t(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:Gn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new _t(0)},specular:{value:new _t(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:Gn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new _t(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:Gn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new _t(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:Gn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:Gn([Le.points,Le.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:Gn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:Gn([Le.common,Le.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:Gn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:Gn([Le.sprite,Le.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:Gn([Le.common,Le.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:Gn([Le.lights,Le.fog,{color:{value:new _t(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};cs.physical={uniforms:Gn([cs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new xt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new nt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new _t(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new xt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new _t(0)},specularColor:{value:new _t(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new xt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var Ah={r:0,b:0,g:0},Ow=new zt,wv=new nt;wv.set(-1,0,0,0,1,0,0,0,1);function kw(i,e,t,n,s,r){let o=new _t(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(x){let M=x.isScene===!0?x.background:null;if(M&&M.isTexture){let b=x.backgroundBlurriness>0;M=e.get(M,b)}return M}function g(x){let M=!1,b=f(x);b===null?m(o,a):b&&b.isColor&&(m(b,1),M=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function v(x,M){let b=f(M);b&&b.isCubeTexture?(c===void 0&&(c=new ln(new Co(1,1,1),new Fn({name:"BackgroundCubeMaterial",uniforms:Cr(cs.backgroundCube.uniforms),vertexShader:cs.backgroundCube.vertexShader,fragmentShader:cs.backgroundCube.fragmentShader,side:jn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,E,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Ow.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(wv),c.material.toneMapped=vt.getTransfer(b.colorSpace)!==Rt,(h!==b||u!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new ln(new Sr(2,2),new Fn({name:"BackgroundMaterial",uniforms:Cr(cs.background.uniforms),vertexShader:cs.background.vertexShader,fragmentShader:cs.background.fragmentShader,side:nr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=vt.getTransfer(b.colorSpace)!==Rt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,M){x.getRGB(Ah,pf(i)),t.buffers.color.setClear(Ah.r,Ah.g,Ah.b,M,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,M=1){o.set(x),a=M,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:g,addToRenderList:v,dispose:p}}function Bw(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(R,O,V,P,H){let Y=!1,k=u(R,P,V,O);r!==k&&(r=k,c(r.object)),Y=f(R,P,V,H),Y&&g(R,P,V,H),H!==null&&e.update(H,i.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(R,O,V,P),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return i.createVertexArray()}function c(R){return i.bindVertexArray(R)}function h(R){return i.deleteVertexArray(R)}function u(R,O,V,P){let H=P.wireframe===!0,Y=n[O.id];Y===void 0&&(Y={},n[O.id]=Y);let k=R.isInstancedMesh===!0?R.id:0,re=Y[k];re===void 0&&(re={},Y[k]=re);let q=re[V.id];q===void 0&&(q={},re[V.id]=q);let j=q[H];return j===void 0&&(j=d(l()),q[H]=j),j}function d(R){let O=[],V=[],P=[];for(let H=0;H<t;H++)O[H]=0,V[H]=0,P[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:V,attributeDivisors:P,object:R,attributes:{},index:null}}function f(R,O,V,P){let H=r.attributes,Y=O.attributes,k=0,re=V.getAttributes();for(let q in re)if(re[q].location>=0){let te=H[q],de=Y[q];if(de===void 0&&(q==="instanceMatrix"&&R.instanceMatrix&&(de=R.instanceMatrix),q==="instanceColor"&&R.instanceColor&&(de=R.instanceColor)),te===void 0||te.attribute!==de||de&&te.data!==de.data)return!0;k++}return r.attributesNum!==k||r.index!==P}function g(R,O,V,P){let H={},Y=O.attributes,k=0,re=V.getAttributes();for(let q in re)if(re[q].location>=0){let te=Y[q];te===void 0&&(q==="instanceMatrix"&&R.instanceMatrix&&(te=R.instanceMatrix),q==="instanceColor"&&R.instanceColor&&(te=R.instanceColor));let de={};de.attribute=te,te&&te.data&&(de.data=te.data),H[q]=de,k++}r.attributes=H,r.attributesNum=k,r.index=P}function v(){let R=r.newAttributes;for(let O=0,V=R.length;O<V;O++)R[O]=0}function m(R){p(R,0)}function p(R,O){let V=r.newAttributes,P=r.enabledAttributes,H=r.attributeDivisors;V[R]=1,P[R]===0&&(i.enableVertexAttribArray(R),P[R]=1),H[R]!==O&&(i.vertexAttribDivisor(R,O),H[R]=O)}function x(){let R=r.newAttributes,O=r.enabledAttributes;for(let V=0,P=O.length;V<P;V++)O[V]!==R[V]&&(i.disableVertexAttribArray(V),O[V]=0)}function M(R,O,V,P,H,Y,k){k===!0?i.vertexAttribIPointer(R,O,V,H,Y):i.vertexAttribPointer(R,O,V,P,H,Y)}function b(R,O,V,P){v();let H=P.attributes,Y=V.getAttributes(),k=O.defaultAttributeValues;for(let re in Y){let q=Y[re];if(q.location>=0){let j=H[re];if(j===void 0&&(re==="instanceMatrix"&&R.instanceMatrix&&(j=R.instanceMatrix),re==="instanceColor"&&R.instanceColor&&(j=R.instanceColor)),j!==void 0){let te=j.normalized,de=j.itemSize,ue=e.get(j);if(ue===void 0)continue;let ee=ue.buffer,me=ue.type,ye=ue.bytesPerElement,Ae=me===i.INT||me===i.UNSIGNED_INT||j.gpuType===Wc;if(j.isInterleavedBufferAttribute){let Me=j.data,Xe=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,rt=j.offset;if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let Ge=0;Ge<q.locationSize;Ge++)p(q.location+Ge,Me.meshPerAttribute);R.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let Ge=0;Ge<q.locationSize;Ge++)m(q.location+Ge);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Ge=0;Ge<q.locationSize;Ge++)M(q.location+Ge,de/q.locationSize,me,te,Xe*ye,(rt+de/q.locationSize*Ge)*ye,Ae)}else{if(j.isInstancedBufferAttribute){for(let Me=0;Me<q.locationSize;Me++)p(q.location+Me,j.meshPerAttribute);R.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let Me=0;Me<q.locationSize;Me++)m(q.location+Me);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Me=0;Me<q.locationSize;Me++)M(q.location+Me,de/q.locationSize,me,te,de*ye,de/q.locationSize*Me*ye,Ae)}}else if(k!==void 0){let te=k[re];if(te!==void 0)switch(te.length){case 2:i.vertexAttrib2fv(q.location,te);break;case 3:i.vertexAttrib3fv(q.location,te);break;case 4:i.vertexAttrib4fv(q.location,te);break;default:i.vertexAttrib1fv(q.location,te)}}}}x()}function C(){U();for(let R in n){let O=n[R];for(let V in O){let P=O[V];for(let H in P){let Y=P[H];for(let k in Y)h(Y[k].object),delete Y[k];delete P[H]}}delete n[R]}}function E(R){if(n[R.id]===void 0)return;let O=n[R.id];for(let V in O){let P=O[V];for(let H in P){let Y=P[H];for(let k in Y)h(Y[k].object),delete Y[k];delete P[H]}}delete n[R.id]}function y(R){for(let O in n){let V=n[O];for(let P in V){let H=V[P];if(H[R.id]===void 0)continue;let Y=H[R.id];for(let k in Y)h(Y[k].object),delete Y[k];delete H[R.id]}}}function S(R){for(let O in n){let V=n[O],P=R.isInstancedMesh===!0?R.id:0,H=V[P];if(H!==void 0){for(let Y in H){let k=H[Y];for(let re in k)h(k[re].object),delete k[re];delete H[Y]}delete V[P],Object.keys(V).length===0&&delete n[O]}}}function U(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:L,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:S,releaseStatesOfProgram:y,initAttributes:v,enableAttribute:m,disableUnusedAttributes:x}}function zw(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Vw(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Vi&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let S=y===zi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==gi&&y!==Bi&&!S&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ze("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ze("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ze("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:x,maxVaryings:M,maxFragmentUniforms:b,maxSamples:C,samples:E}}function Gw(i){let e=this,t=null,n=0,s=!1,r=!1,o=new fi,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let g=u.clippingPlanes,v=u.clipIntersection,m=u.clipShadows,p=i.get(u);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let x=r?0:n,M=x*4,b=p.clippingState||null;l.value=b,b=h(g,d,M,f);for(let C=0;C!==M;++C)b[C]=t[C];p.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,g){let v=u!==null?u.length:0,m=null;if(v!==0){if(m=l.value,g!==!0||m===null){let p=f+v*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<p)&&(m=new Float32Array(p));for(let M=0,b=f;M!==v;++M,b+=4)o.copy(u[M]).applyMatrix4(x,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,m}}var $a=class extends Kn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Pa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Co(5,5,5),r=new Fn({name:"CubemapFromEquirect",uniforms:Cr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:jn,blending:wr});r.uniforms.tEquirect.value=t;let o=new ln(s,r),a=t.minFilter;return t.minFilter===Oi&&(t.minFilter=Dn),new Lo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},nv=256,Hw=3,Ww=20,Ev=256,Tv=16,Xw=3,qw=new W,$w=new _t,Rh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Lo(1,10,null),this._boxMesh=new ln(new Co(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=qw}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor($w));let m=new Lo(n,s,h);return m.position.copy(a),m.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=v,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=rv(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=sv(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(nv,K0(e))}_fromTexture(e,t){e.mapping===Tr||e.mapping===Uo?this._setSize(e.image.length===0?nv:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=iv(e,!1,!1),n=Math.log2(e)-Hw;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=iv(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Tr||e.mapping===Uo?(this._cubemapMaterial===null&&(this._cubemapMaterial=rv()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=sv()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Yw(),this._integrationMaterial=Jw());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Tv);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Xw)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Ev*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Zw());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function iv(i,e,t){return new $a(i,{minFilter:Oi,generateMipmaps:e,type:zi,colorSpace:Ma,depthBuffer:t})}function Ya(i,e,t){return new Fn({name:i,uniforms:e,vertexShader:ht.cube_vert,fragmentShader:t,side:jn,blending:wr,depthTest:!1,depthWrite:!1})}function Yw(){return Ya("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Ev}u

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
	`)}function Jw(){return Ya("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Tv}},`

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
	`)}function Zw(){return Ya("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Ww}
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
	`)}function sv(){return Ya("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function rv(){return Ya("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Kw(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Vc||f===Gc)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let v=new $a(g.height);return v.fromEquirectangularTexture(i,d),e.set(d,v),d.addEventListener("dispose",c),a(v.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===Vc||f===Gc,v=f===Tr||f===Uo;if(g||v){let m=t.get(d),p=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==p)return n===null&&(n=new Rh(i)),m=g?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let x=d.image;return g&&x&&x.height>0||v&&x&&l(x)?(n===null&&(n=new Rh(i)),m=g?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===Vc?d.mapping=Tr:f===Gc&&(d.mapping=Uo),d}function l(d){let f=0,g=6;for(let v=0;v<g;v++)d[v]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function jw(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&_a("WebGLRenderer: "+n+" extension not supported."),s}}}function Qw(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let v=r.get(g);v&&(e.remove(v),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function h(g){let v=g.attributes;for(let m in v)e.update(v[m],i.ARRAY_BUFFER)}function u(g){let v=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let x=v!==null?v.array.length:m.array.length/3-1,M=m.count>=65535?Ra:Ca,b=new M(Math.ceil(x/3)*6,1),C=b.array;if(v!==null){let y=v.array;p=v.version;for(let S=0,U=0;S<x;S+=3){let L=y[S+0],R=y[S+1],O=y[S+2];C[U++]=L,C[U++]=R,C[U++]=R,C[U++]=O,C[U++]=O,C[U++]=L}}else{p=m.version;for(let y=0,S=0;y<x;y+=3){let U=y+0,L=y+1,R=y+2;C[S++]=U,C[S++]=L,C[S++]=L,C[S++]=R,C[S++]=R,C[S++]=U}}b.version=p;let E=r.get(g);E&&e.remove(E),r.set(g,b)}function d(g){let v=r.get(g);if(v){let m=g.index;m!==null&&v.version<m.version&&u(g)}else u(g);return r.get(g)}function f(){for(let g in s){let v=s[g].deref();v!==void 0&&l(v)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function e1(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let v=0;for(let m=0;m<f;m++)v+=d[m];t.update(v,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function t1(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:tt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function n1(i,e,t){let n=new WeakMap,s=new jt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let U=function(){y.dispose(),n.delete(a),a.removeEventListener("dispose",U)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],M=0;f===!0&&(M=1),g===!0&&(M=2),v===!0&&(M=3);let b=a.attributes.position.count*M,C=1;b>e.maxTextureSize&&(C=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let E=new Float32Array(b*C*4*u),y=new Ta(E,b,C,u);y.type=Bi,y.needsUpdate=!0;let S=M*4;for(let L=0;L<u;L++){let R=m[L],O=p[L],V=x[L],P=b*C*4*L;for(let H=0;H<R.count;H++){let Y=H*S;f===!0&&(s.fromBufferAttribute(R,H),E[P+Y+0]=s.x,E[P+Y+1]=s.y,E[P+Y+2]=s.z,E[P+Y+3]=0),g===!0&&(s.fromBufferAttribute(O,H),E[P+Y+4]=s.x,E[P+Y+5]=s.y,E[P+Y+6]=s.z,E[P+Y+7]=0),v===!0&&(s.fromBufferAttribute(V,H),E[P+Y+8]=s.x,E[P+Y+9]=s.y,E[P+Y+10]=s.z,E[P+Y+11]=V.itemSize===4?s.w:1)}}d={count:u,texture:y,size:new xt(b,C)},n.set(a,d),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function i1(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var s1={[Xd]:"LINEAR_TONE_MAPPING",[qd]:"REINHARD_TONE_MAPPING",[$d]:"CINEON_TONE_MAPPING",[Yd]:"ACES_FILMIC_TONE_MAPPING",[Zd]:"AGX_TONE_MAPPING",[Kd]:"NEUTRAL_TONE_MAPPING",[Jd]:"CUSTOM_TONE_MAPPING"};function r1(i,e,t,n,s,r){let o=new Kn(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Un;h.setAttribute("position",new Kt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Kt([0,2,0,0,2,0],2));let u=new Ac({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new ln(h,u),f=new Io(-1,1,1,-1,0,1),g=null,v=null,m=!1,p,x=null,M=[],b=!1;this.setSize=function(C,E){o.setSize(C,E),a!==null&&a.setSize(C,E),l!==null&&l.setSize(C,E);for(let y=0;y<M.length;y++){let S=M[y];S.setSize&&S.setSize(C,E)}},this.setEffects=function(C){M=C,b=M.length>0&&M[0].isRenderPass===!0;let E=o.width,y=o.height;M.length>0&&a===null&&(a=new Kn(E,y,{type:zi,depthBuffer:!1,stencilBuffer:!1}),l=new Kn(E,y,{type:zi,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&M.some(U=>U.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new Es(E,y),r===!0&&(c.format=As,c.type=Ar)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let U=0;U<M.length;U++){let L=M[U];L.setSize&&L.setSize(E,y),S&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(C,E){if(m||C.toneMapping===as&&M.length===0)return!1;if(x=E,E!==null){let y=E.width,S=E.height;(o.width!==y||o.height!==S)&&this.setSize(y,S)}return b===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=as,!0},this.hasRenderPass=function(){return b},this.end=function(C,E){C.toneMapping=p,m=!0;let y=o,S=a;for(let U=0;U<M.length;U++){let L=M[U];L.enabled!==!1&&(L.render(C,S,y,E),L.needsSwap!==!1&&(y=S,S=S===a?l:a))}if(g!==C.outputColorSpace||v!==C.toneMapping){g=C.outputColorSpace,v=C.toneMapping,u.defines={},vt.getTransfer(g)===Rt&&(u.defines.SRGB_TRANSFER="");let U=s1[v];U&&(u.defines[U]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,C.setRenderTarget(x),C.render(d,f),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Av=new ei,Cv=new Es(1,1),Rv=new Ia(1),Pv=new Ta,Iv=new yc,Lv=new Pa,ov=[],av=[],lv=new Float32Array(16),cv=new Float32Array(9),hv=new Float32Array(4);function ko(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=ov[s];if(r===void 0&&(r=new Float32Array(s),ov[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function bn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Mn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Ih(i,e){let t=av[e];t===void 0&&(t=new Int32Array(e),av[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function o1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function a1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bn(t,e))return;i.uniform2fv(this.addr,e),Mn(t,e)}}function l1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(bn(t,e))return;i.uniform3fv(this.addr,e),Mn(t,e)}}function c1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bn(t,e))return;i.uniform4fv(this.addr,e),Mn(t,e)}}function h1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(bn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Mn(t,e)}else{if(bn(t,n))return;hv.set(n),i.uniformMatrix2fv(this.addr,!1,hv),Mn(t,n)}}function u1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(bn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Mn(t,e)}else{if(bn(t,n))return;cv.set(n),i.uniformMatrix3fv(this.addr,!1,cv),Mn(t,n)}}function d1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(bn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Mn(t,e)}else{if(bn(t,n))return;lv.set(n),i.uniformMatrix4fv(this.addr,!1,lv),Mn(t,n)}}function f1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function p1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bn(t,e))return;i.uniform2iv(this.addr,e),Mn(t,e)}}function m1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(bn(t,e))return;i.uniform3iv(this.addr,e),Mn(t,e)}}function g1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bn(t,e))return;i.uniform4iv(this.addr,e),Mn(t,e)}}function v1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function y1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bn(t,e))return;i.uniform2uiv(this.addr,e),Mn(t,e)}}function x1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(bn(t,e))return;i.uniform3uiv(this.addr,e),Mn(t,e)}}function _1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bn(t,e))return;i.uniform4uiv(this.addr,e),Mn(t,e)}}function Lh(i){return i.version===0&&(i.compareFunction=hf,i.needsUpdate=!0),i}function b1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Lh(Cv):r=Av,t.setTexture2D(e||r,s)}function M1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Iv,s)}function S1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Lh(Rv):r=Lv,t.setTextureCube(e||r,s)}function w1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Pv,s)}function E1(i){switch(i){case 5126:return o1;case 35664:return a1;case 35665:return l1;case 35666:return c1;case 35674:return h1;case 35675:return u1;case 35676:return d1;case 5124:case 35670:return f1;case 35667:case 35671:return p1;case 35668:case 35672:return m1;case 35669:case 35673:return g1;case 5125:return v1;case 36294:return y1;case 36295:return x1;case 36296:return _1;case 35678:case 36198:case 36298:case 36306:case 35682:return b1;case 35679:case 36299:case 36307:return M1;case 35680:case 36300:case 36308:case 36293:return S1;case 36289:case 36303:case 36311:case 36292:return w1}}function T1(i,e){i.uniform1fv(this.addr,e)}function A1(i,e){let t=ko(e,this.size,2);i.uniform2fv(this.addr,t)}function C1(i,e){let t=ko(e,this.size,3);i.uniform3fv(this.addr,t)}function R1(i,e){let t=ko(e,this.size,4);i.uniform4fv(this.addr,t)}function P1(i,e){let t=ko(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function I1(i,e){let t=ko(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function L1(i,e){let t=ko(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function N1(i,e){i.uniform1iv(this.addr,e)}function D1(i,e){i.uniform2iv(this.addr,e)}function U1(i,e){i.uniform3iv(this.addr,e)}function F1(i,e){i.uniform4iv(this.addr,e)}function O1(i,e){i.uniform1uiv(this.addr,e)}function k1(i,e){i.uniform2uiv(this.addr,e)}function B1(i,e){i.uniform3uiv(this.addr,e)}function z1(i,e){i.uniform4uiv(this.addr,e)}function V1(i,e,t){let n=this.cache,s=e.length,r=Ih(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Lh(Cv):o=Av;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function G1(i,e,t){let n=this.cache,s=e.length,r=Ih(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Iv,r[o])}function H1(i,e,t){let n=this.cache,s=e.length,r=Ih(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Lh(Rv):o=Lv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function W1(i,e,t){let n=this.cache,s=e.length,r=Ih(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Pv,r[o])}function X1(i){switch(i){case 5126:return T1;case 35664:return A1;case 35665:return C1;case 35666:return R1;case 35674:return P1;case 35675:return I1;case 35676:return L1;case 5124:case 35670:return N1;case 35667:case 35671:return D1;case 35668:case 35672:return U1;case 35669:case 35673:return F1;case 5125:return O1;case 36294:return k1;case 36295:return B1;case 36296:return z1;case 35678:case 36198:case 36298:case 36306:case 35682:return V1;case 35679:case 36299:case 36307:return G1;case 35680:case 36300:case 36308:case 36293:return H1;case 36289:case 36303:case 36311:case 36292:return W1}}var _f=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=E1(t.type)}},bf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=X1(t.type)}},Mf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},yf=/(\w+)(\])?(\[|\.)?/g;function uv(i,e){i.seq.push(e),i.map[e.id]=e}function q1(i,e,t){let n=i.name,s=n.length;for(yf.lastIndex=0;;){let r=yf.exec(n),o=yf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){uv(t,c===void 0?new _f(a,i,e):new bf(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Mf(a),uv(t,u)),t=u}}}var Oo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);q1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function dv(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var $1=37297,Y1=0;function J1(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var fv=new nt;function Z1(i){vt._getMatrix(fv,vt.workingColorSpace,i);let e=`mat3( ${fv.elements.map(t=>t.toFixed(4))} )`;switch(vt.getTransfer(i)){case Sa:return[e,"LinearTransferOETF"];case Rt:return[e,"sRGBTransferOETF"];default:return Ze("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function pv(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+J1(i.getShaderSource(e),a)}else return r}function K1(i,e){let t=Z1(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var j1={[Xd]:"Linear",[qd]:"Reinhard",[$d]:"Cineon",[Yd]:"ACESFilmic",[Zd]:"AgX",[Kd]:"Neutral",[Jd]:"Custom"};function Q1(i,e){let t=j1[e];return t===void 0?(Ze("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ch=new W;function eE(){vt.getLuminanceCoefficients(Ch);let i=Ch.x.toFixed(4),e=Ch.y.toFixed(4),t=Ch.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function tE(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(qa).join(`
`)}function nE(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function iE(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function qa(i){return i!==""}function mv(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function gv(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var sE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Sf(i){return i.replace(sE,rE)}function rE(i,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Sf(t)}var oE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function vv(i){return i.replace(oE,aE)}function aE(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function yv(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var lE={[Fa]:"SHADOWMAP_TYPE_PCF",[No]:"SHADOWMAP_TYPE_VSM"};function cE(i){return lE[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var hE={[Uo]:"ENVMAP_MODE_REFRACTION"};function uE(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":hE[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var dE={[Wd]:"ENVMAP_BLENDING_MULTIPLY",[U0]:"ENVMAP_BLENDING_MIX",[F0]:"ENVMAP_BLENDING_ADD"};function fE(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":dE[i.combine]||"ENVMAP_BLENDING_NONE"}function pE(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=cE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=uE(t),u=fE(t),d=tE(t),f=nE(r),g=s.createProgram(),v,m,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(qa).join(`
`),v.length>0&&(v+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(qa).join(`
`),m.length>0&&(m+=`
`)):(v=[yv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(qa).join(`
`),m=[yv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==as?"#define TONE_MAPPING":"",t.toneMapping!==as?ht.tonemapping_pars_fragment:"",t.toneMapping!==as?Q1("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,K1("linearToOutputTexel",t.outputColorSpace),eE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(qa).join(`
`)),o=Sf(o),o=mv(o,t),o=gv(o,t),a=Sf(a),a=mv(a,t),a=gv(a,t),o=vv(o),a=vv(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,v=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,m=["#define varying in",t.glslVersion===uf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===uf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=p+v+o,M=p+m+a,b=dv(s,s.VERTEX_SHADER,x),C=dv(s,s.FRAGMENT_SHADER,M);s.attachShader(g,b),s.attachShader(g,C),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(L){if(i.debug.checkShaderErrors){let R=s.getProgramInfoLog(g)||"",O=s.getShaderInfoLog(b)||"",V=s.getShaderInfoLog(C)||"",P=R.trim(),H=O.trim(),Y=V.trim(),k=!0,re=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(k=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,b,C);else{let q=pv(s,b,"vertex"),j=pv(s,C,"fragment");tt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+P+`
`+q+`
`+j)}else P!==""?Ze("WebGLProgram: Program Info Log:",P):(H===""||Y==="")&&(re=!1);re&&(L.diagnostics={runnable:k,programLog:P,vertexShader:{log:H,prefix:v},fragmentShader:{log:Y,prefix:m}})}s.deleteShader(b),s.deleteShader(C),y=new Oo(s,g),S=iE(s,g)}let y;this.getUniforms=function(){return y===void 0&&E(this),y};let S;this.getAttributes=function(){return S===void 0&&E(this),S};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(g,$1)),U},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Y1++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=b,this.fragmentShader=C,this}var mE=0,wf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Ef(e),t.set(e,n)),n}},Ef=class{constructor(e){this.id=mE++,this.code=e,this.usedTimes=0}};function gE(i){return i===ir||i===Ga||i===Ha}function vE(i,e,t,n,s,r){let o=new Aa,a=new wf,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function g(y,S,U,L,R,O){let V=L.fog,P=R.geometry,H=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,Y=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,k=e.get(y.envMap||H,Y),re=d[y.type],q=n.precision;y.precision!==null&&(q=n.getMaxPrecision(y.precision),q!==y.precision&&Ze("WebGLProgram.getParameters:",y.precision,"not supported, using",q,"instead."));let j=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,te=j!==void 0?j.length:0,de=0;P.morphAttributes.position!==void 0&&(de=1),P.morphAttributes.normal!==void 0&&(de=2),P.morphAttributes.color!==void 0&&(de=3);let ue,ee,me,ye;if(re){let Ce=cs[re];ue=Ce.vertexShader,ee=Ce.fragmentShader}else{ue=y.vertexShader,ee=y.fragmentShader;let Ce=a.getVertexShaderStage(y),at=a.getFragmentShaderStage(y);a.update(y,Ce,at),me=Ce.id,ye=at.id}let Ae=i.getRenderTarget(),Me=i.state.buffers.depth.getReversed(),Xe=R.isInstancedMesh===!0,rt=R.isBatchedMesh===!0,Ge=!!y.map,ut=!!y.matcap,lt=!!k,it=lt&&k.isPMREMTexture===!0,$t=!!y.aoMap,Bt=!!y.lightMap,cn=!!y.bumpMap&&y.wireframe===!1,Nt=!!y.normalMap,Sn=!!y.displacementMap,bt=!!y.emissiveMap,vn=!!y.metalnessMap,Qt=!!y.roughnessMap,hn=y.anisotropy>0,z=y.clearcoat>0,Re=y.diffuseRoughness>0,Je=y.dispersion>0,ot=y.retroreflectivity>0,Se=y.iridescence>0,Ft=y.sheen>0,Ve=y.transmission>0,$e=hn&&!!y.anisotropyMap,I=z&&!!y.clearcoatMap,w=z&&!!y.clearcoatNormalMap,$=z&&!!y.clearcoatRoughnessMap,he=Re&&!!y.diffuseRoughnessMap,ae=Se&&!!y.iridescenceMap,ve=Se&&!!y.iridescenceThicknessMap,xe=Ft&&!!y.sheenColorMap,ne=Ft&&!!y.sheenRoughnessMap,se=!!y.specularMap,pe=!!y.specularColorMap,B=!!y.specularIntensityMap,oe=Ve&&!!y.transmissionMap,ie=Ve&&!!y.thicknessMap,we=!!y.gradientMap,ge=!!y.alphaMap,be=y.alphaTest>0,He=!!y.alphaHash,je=!!y.extensions,ce=as;y.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(ce=i.toneMapping);let ke=it?k.isCompressedCubeTexture?k.image[0].mipmaps:k.mipmaps:null,Qe={shaderID:re,shaderType:y.type,shaderName:y.name,vertexShader:ue,fragmentShader:ee,defines:y.defines,customVertexShaderID:me,customFragmentShaderID:ye,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:q,batching:rt,batchingColor:rt&&R._colorsTexture!==null,instancing:Xe,instancingColor:Xe&&R.instanceColor!==null,instancingMorph:Xe&&R.morphTexture!==null,outputColorSpace:Ae===null?i.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:vt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Ge,matcap:ut,envMap:lt,envMapMode:lt&&k.mapping,envMapPMREM:it,envMapMaxLod:it?ke.length-1:null,envMapSize:it?ke[0].width:null,aoMap:$t,lightMap:Bt,bumpMap:cn,normalMap:Nt,displacementMap:Sn,emissiveMap:bt,normalMapObjectSpace:Nt&&y.normalMapType===B0,normalMapTangentSpace:Nt&&y.normalMapType===af,packedNormalMap:Nt&&y.normalMapType===af&&gE(y.normalMap.format),metalnessMap:vn,roughnessMap:Qt,anisotropy:hn,anisotropyMap:$e,clearcoat:z,clearcoatMap:I,clearcoatNormalMap:w,clearcoatRoughnessMap:$,diffuseRoughness:Re,diffuseRoughnessMap:he,dispersion:Je,retroreflection:ot,iridescence:Se,iridescenceMap:ae,iridescenceThicknessMap:ve,sheen:Ft,sheenColorMap:xe,sheenRoughnessMap:ne,specularMap:se,specularColorMap:pe,specularIntensityMap:B,transmission:Ve,transmissionMap:oe,thicknessMap:ie,gradientMap:we,opaque:y.transparent===!1&&y.blending===Do&&y.alphaToCoverage===!1,alphaMap:ge,alphaTest:be,alphaHash:He,combine:y.combine,mapUv:Ge&&f(y.map.channel),aoMapUv:$t&&f(y.aoMap.channel),lightMapUv:Bt&&f(y.lightMap.channel),bumpMapUv:cn&&f(y.bumpMap.channel),normalMapUv:Nt&&f(y.normalMap.channel),displacementMapUv:Sn&&f(y.displacementMap.channel),emissiveMapUv:bt&&f(y.emissiveMap.channel),metalnessMapUv:vn&&f(y.metalnessMap.channel),roughnessMapUv:Qt&&f(y.roughnessMap.channel),anisotropyMapUv:$e&&f(y.anisotropyMap.channel),clearcoatMapUv:I&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:xe&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:ne&&f(y.sheenRoughnessMap.channel),specularMapUv:se&&f(y.specularMap.channel),specularColorMapUv:pe&&f(y.specularColorMap.channel),specularIntensityMapUv:B&&f(y.specularIntensityMap.channel),transmissionMapUv:oe&&f(y.transmissionMap.channel),thicknessMapUv:ie&&f(y.thicknessMap.channel),alphaMapUv:ge&&f(y.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(Nt||hn),vertexNormals:!!P.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:R.isPoints===!0&&!!P.attributes.uv&&(Ge||ge),fog:!!V,useFog:y.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||P.attributes.normal===void 0&&Nt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Me,skinning:R.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:de,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:O.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&U.length>0,shadowMapType:i.shadowMap.type,toneMapping:ce,decodeVideoTexture:Ge&&y.map.isVideoTexture===!0&&vt.getTransfer(y.map.colorSpace)===Rt,decodeVideoTextureEmissive:bt&&y.emissiveMap.isVideoTexture===!0&&vt.getTransfer(y.emissiveMap.colorSpace)===Rt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===os,flipSided:y.side===jn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:je&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(je&&y.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Qe.vertexUv1s=l.has(1),Qe.vertexUv2s=l.has(2),Qe.vertexUv3s=l.has(3),l.clear(),Qe}function v(y){let S=[];if(y.shaderID?S.push(y.shaderID):(S.push(y.customVertexShaderID),S.push(y.customFragmentShaderID)),y.defines!==void 0)for(let U in y.defines)S.push(U),S.push(y.defines[U]);return y.isRawShaderMaterial===!1&&(m(S,y),p(S,y),S.push(i.outputColorSpace)),S.push(y.customProgramCacheKey),S.join()}function m(y,S){y.push(S.precision),y.push(S.outputColorSpace),y.push(S.envMapMode),y.push(S.envMapPMREM),y.push(S.envMapMaxLod),y.push(S.envMapSize),y.push(S.mapUv),y.push(S.alphaMapUv),y.push(S.lightMapUv),y.push(S.aoMapUv),y.push(S.bumpMapUv),y.push(S.normalMapUv),y.push(S.displacementMapUv),y.push(S.emissiveMapUv),y.push(S.metalnessMapUv),y.push(S.roughnessMapUv),y.push(S.anisotropyMapUv),y.push(S.clearcoatMapUv),y.push(S.clearcoatNormalMapUv),y.push(S.clearcoatRoughnessMapUv),y.push(S.diffuseRoughnessMapUv),y.push(S.iridescenceMapUv),y.push(S.iridescenceThicknessMapUv),y.push(S.sheenColorMapUv),y.push(S.sheenRoughnessMapUv),y.push(S.specularMapUv),y.push(S.specularColorMapUv),y.push(S.specularIntensityMapUv),y.push(S.transmissionMapUv),y.push(S.thicknessMapUv),y.push(S.combine),y.push(S.fogExp2),y.push(S.sizeAttenuation),y.push(S.morphTargetsCount),y.push(S.numSunLights),y.push(S.numDirLights),y.push(S.numPointLights),y.push(S.numSpotLights),y.push(S.numSpotLightMaps),y.push(S.numHemiLights),y.push(S.numRectAreaLights),y.push(S.numSunLightShadows),y.push(S.numDirLightShadows),y.push(S.numPointLightShadows),y.push(S.numSpotLightShadows),y.push(S.numSpotLightShadowsWithMaps),y.push(S.numLightProbes),y.push(S.numLightProbeGrids),y.push(S.shadowMapType),y.push(S.toneMapping),y.push(S.numClippingPlanes),y.push(S.numClipIntersection),y.push(S.depthPacking)}function p(y,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let S=d[y.type],U;if(S){let L=cs[S];U=Q0.clone(L.uniforms)}else U=y.uniforms;return U}function M(y,S){let U=h.get(S);return U!==void 0?++U.usedTimes:(U=new pE(i,S,y,s),c.push(U),h.set(S,U)),U}function b(y){if(--y.usedTimes===0){let S=c.indexOf(y);c[S]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function C(y){a.remove(y)}function E(){a.dispose()}return{getParameters:g,getProgramCacheKey:v,getUniforms:x,acquireProgram:M,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:E}}function yE(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function xE(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function xv(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function _v(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,v,m,p){let x=i[e];return x===void 0?(x={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:v,renderOrder:d.renderOrder,z:m,group:p},i[e]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=g,x.materialVariant=o(d),x.groupOrder=v,x.renderOrder=d.renderOrder,x.z=m,x.group=p),e++,x}function l(d,f,g,v,m,p,x){x.reversedDepth===!0&&(m=-m);let M=a(d,f,g,v,m,p);g.transmission>0?n.push(M):g.transparent===!0?s.push(M):t.push(M)}function c(d,f,g,v,m,p){let x=a(d,f,g,v,m,p);g.transmission>0?n.unshift(x):g.transparent===!0?s.unshift(x):t.unshift(x)}function h(d,f){t.length>1&&t.sort(d||xE),n.length>1&&n.sort(f||xv),s.length>1&&s.sort(f||xv)}function u(){for(let d=e,f=i.length;d<f;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function _E(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new _v,i.set(n,[o])):s>=r.length?(o=new _v,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function bE(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new W,color:new _t};break;case"SpotLight":t={position:new W,direction:new W,color:new _t,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new W,color:new _t,distance:0,decay:0};break;case"HemisphereLight":t={direction:new W,skyColor:new _t,groundColor:new _t};break;case"RectAreaLight":t={color:new _t,position:new W,halfWidth:new W,halfHeight:new W};break}return i[e.id]=t,t}}}function ME(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var SE=0;function wE(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function EE(i){let e=new bE,t=ME(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new W);let s=new W,r=new zt,o=new zt;function a(c){let h=0,u=0,d=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let f=0,g=0,v=0,m=0,p=0,x=0,M=0,b=0,C=0,E=0,y=0,S=0,U=0,L=0;c.sort(wE);for(let O=0,V=c.length;O<V;O++){let P=c[O],H=P.color,Y=P.intensity,k=P.distance,re=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===ir?re=P.shadow.map.texture:re=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)h+=H.r*Y,u+=H.g*Y,d+=H.b*Y;else if(P.isLightProbe){for(let q=0;q<9;q++)n.probe[q].addScaledVector(P.sh.coefficients[q],Y);L++}else if(P.isSunLight){let q=e.get(P);if(q.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let j=P.shadow,te=t.get(P);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),n.sunShadow[g]=te,n.sunShadowMap[g]=re;let de=j.getViewportCount();for(let ue=0;ue<de;ue++)n.sunShadowMatrix[v+ue]=j.getMatrix(ue),n.sunShadowCascade[v+ue]=j._cascadeData[ue];v+=de,g++}n.sun[f]=q,f++}else if(P.isDirectionalLight){let q=e.get(P);if(q.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let j=P.shadow,te=t.get(P);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,n.directionalShadow[m]=te,n.directionalShadowMap[m]=re,n.directionalShadowMatrix[m]=P.shadow.matrix,C++}n.directional[m]=q,m++}else if(P.isSpotLight){let q=e.get(P);q.position.setFromMatrixPosition(P.matrixWorld),q.color.copy(H).multiplyScalar(Y),q.distance=k,q.coneCos=Math.cos(P.angle),q.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),q.decay=P.decay,n.spot[x]=q;let j=P.shadow;if(P.map&&(n.spotLightMap[S]=P.map,S++,j.updateMatrices(P),P.castShadow&&U++),n.spotLightMatrix[x]=j.matrix,P.castShadow){let te=t.get(P);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,n.spotShadow[x]=te,n.spotShadowMap[x]=re,y++}x++}else if(P.isRectAreaLight){let q=e.get(P);q.color.copy(H).multiplyScalar(Y),q.halfWidth.set(P.width*.5,0,0),q.halfHeight.set(0,P.height*.5,0),n.rectArea[M]=q,M++}else if(P.isPointLight){let q=e.get(P);if(q.color.copy(P.color).multiplyScalar(P.intensity),q.distance=P.distance,q.decay=P.decay,P.castShadow){let j=P.shadow,te=t.get(P);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,te.shadowCameraNear=j.camera.near,te.shadowCameraFar=j.camera.far,n.pointShadow[p]=te,n.pointShadowMap[p]=re,n.pointShadowMatrix[p]=P.shadow.matrix,E++}n.point[p]=q,p++}else if(P.isHemisphereLight){let q=e.get(P);q.skyColor.copy(P.color).multiplyScalar(Y),q.groundColor.copy(P.groundColor).multiplyScalar(Y),n.hemi[b]=q,b++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Le.LTC_FLOAT_1,n.rectAreaLTC2=Le.LTC_FLOAT_2):(n.rectAreaLTC1=Le.LTC_HALF_1,n.rectAreaLTC2=Le.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let R=n.hash;(R.sunLength!==f||R.directionalLength!==m||R.pointLength!==p||R.spotLength!==x||R.rectAreaLength!==M||R.hemiLength!==b||R.numSunShadows!==g||R.numDirectionalShadows!==C||R.numPointShadows!==E||R.numSpotShadows!==y||R.numSpotMaps!==S||R.numLightProbes!==L)&&(n.sun.length=f,n.directional.length=m,n.spot.length=x,n.rectArea.length=M,n.point.length=p,n.hemi.length=b,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=v,n.sunShadowCascade.length=v,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+S-U,n.spotLightMap.length=S,n.numSpotLightShadowsWithMaps=U,n.numLightProbes=L,R.sunLength=f,R.directionalLength=m,R.pointLength=p,R.spotLength=x,R.rectAreaLength=M,R.hemiLength=b,R.numSunShadows=g,R.numDirectionalShadows=C,R.numPointShadows=E,R.numSpotShadows=y,R.numSpotMaps=S,R.numLightProbes=L,n.version=SE++)}function l(c,h){let u=0,d=0,f=0,g=0,v=0,m=0,p=h.matrixWorldInverse;for(let x=0,M=c.length;x<M;x++){let b=c[x];if(b.isSunLight){let C=n.sun[u];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(p),u++}else if(b.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),d++}else if(b.isSpotLight){let C=n.spot[g];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),g++}else if(b.isRectAreaLight){let C=n.rectArea[v];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),o.identity(),r.copy(b.matrixWorld),r.premultiply(p),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),v++}else if(b.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),f++}else if(b.isHemisphereLight){let C=n.hemi[m];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:n}}function bv(i){let e=new EE(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function TE(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new bv(i),e.set(s,[a])):r>=o.length?(a=new bv(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var AE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,CE=`uniform sampler2D shadow_pass;
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
}`,RE=[new W(1,0,0),new W(-1,0,0),new W(0,1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1)],PE=[new W(0,-1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1),new W(0,-1,0),new W(0,-1,0)],Mv=new zt,Xa=new W,xf=new W;function IE(i,e,t){let n=new Mr,s=new xt,r=new xt,o=new jt,a=new Cc,l=new Rc,c={},h=t.maxTextureSize,u={[nr]:jn,[jn]:nr,[os]:os},d=new Fn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new xt},radius:{value:4}},vertexShader:AE,fragmentShader:CE}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Un;g.setAttribute("position",new Vn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new ln(g,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Fa;let p=this.type;this.render=function(E,y,S){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===g0&&(Ze("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Fa);let U=i.getRenderTarget(),L=i.getActiveCubeFace(),R=i.getActiveMipmapLevel(),O=i.state;O.setBlending(wr),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let V=p!==this.type;V&&y.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(H=>H.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,H=E.length;P<H;P++){let Y=E[P],k=Y.shadow;if(k===void 0){Ze("WebGLShadowMap:",Y,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);let re=k.getFrameExtents();s.multiply(re),r.copy(k.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/re.x),s.x=r.x*re.x,k.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/re.y),s.y=r.y*re.y,k.mapSize.y=r.y));let q=i.state.buffers.depth.getReversed();if(k.camera._reversedDepth=q,k.map===null||V===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===No){if(Y.isPointLight){Ze("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}k.map=new Kn(s.x,s.y,{format:ir,type:zi,minFilter:Dn,magFilter:Dn,generateMipmaps:!1}),k.map.texture.name=Y.name+".shadowMap",k.map.depthTexture=new Es(s.x,s.y,Bi),k.map.depthTexture.name=Y.name+".shadowMapDepth",k.map.depthTexture.format=Ss,k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=In,k.map.depthTexture.magFilter=In}else Y.isPointLight?(k.map=new $a(s.x),k.map.depthTexture=new Ia(s.x,ki)):(k.map=new Kn(s.x,s.y),k.map.depthTexture=new Es(s.x,s.y,ki)),k.map.depthTexture.name=Y.name+".shadowMap",k.map.depthTexture.format=Ss,this.type===Fa?(k.map.depthTexture.compareFunction=q?cf:lf,k.map.depthTexture.minFilter=Dn,k.map.depthTexture.magFilter=Dn):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=In,k.map.depthTexture.magFilter=In);k.camera.updateProjectionMatrix()}k.map.isWebGLCubeRenderTarget!==!0&&(k.map.width!==s.x||k.map.height!==s.y)&&k.map.setSize(s.x,s.y);let j=k.map.isWebGLCubeRenderTarget?6:k.getViewportCount();Y.isPointLight!==!0&&k.updateMatrices(Y,S);let te=(k.camera.layers.mask&4294967294)!==0?k.camera.layers:S.layers;for(let de=0;de<j;de++){let ue=k.getCamera(de);if(Y.isPointLight){let ee=k.camera,me=k.matrix,ye=Y.distance||ee.far;ye!==ee.far&&(ee.far=ye,ee.updateProjectionMatrix()),Xa.setFromMatrixPosition(Y.matrixWorld),ee.position.copy(Xa),xf.copy(ee.position),xf.add(RE[de]),ee.up.copy(PE[de]),ee.lookAt(xf),ee.updateMatrixWorld(),me.makeTranslation(-Xa.x,-Xa.y,-Xa.z),Mv.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),k._frustum.setFromProjectionMatrix(Mv,ee.coordinateSystem,ee.reversedDepth)}if(k.map.isWebGLCubeRenderTarget)i.setRenderTarget(k.map,de),i.clear();else{de===0&&(i.setRenderTarget(k.map),i.clear());let ee=k.getViewport(de);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),O.viewport(o)}n=k.getFrustum(de),b(y,S,ue,Y,te,this.type)}k.isPointLightShadow!==!0&&this.type===No&&x(k,S),k.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(U,L,R)};function x(E,y){let S=e.update(v);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new Kn(s.x,s.y,{format:ir,type:zi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(y,null,S,d,v,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(y,null,S,f,v,null)}function M(E,y,S,U){let L=null,R=S.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(R!==void 0)L=R;else if(L=S.isPointLight===!0?l:a,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let O=L.uuid,V=y.uuid,P=c[O];P===void 0&&(P={},c[O]=P);let H=P[V];H===void 0&&(H=L.clone(),P[V]=H,y.addEventListener("dispose",C)),L=H}if(L.visible=y.visible,L.wireframe=y.wireframe,U===No?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:u[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,S.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let O=i.properties.get(L);O.light=S}return L}function b(E,y,S,U,L,R){if(E.visible===!1)return;if(E.layers.test(L)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&R===No)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,E.matrixWorld);let P=e.update(E),H=E.material;if(Array.isArray(H)){let Y=P.groups;for(let k=0,re=Y.length;k<re;k++){let q=Y[k],j=H[q.materialIndex];if(j&&j.visible){let te=M(E,j,U,R);E.onBeforeShadow(i,E,y,S,P,te,q),i.renderBufferDirect(S,null,P,te,E,q),E.onAfterShadow(i,E,y,S,P,te,q)}}}else if(H.visible){let Y=M(E,H,U,R);E.onBeforeShadow(i,E,y,S,P,Y,null),i.renderBufferDirect(S,null,P,Y,E,null),E.onAfterShadow(i,E,y,S,P,Y,null)}}let V=E.children;for(let P=0,H=V.length;P<H;P++)b(V[P],y,S,U,L,R)}function C(E){E.target.removeEventListener("dispose",C);for(let S in c){let U=c[S],L=E.target.uuid;L in U&&(U[L].dispose(),delete U[L])}}}function LE(i,e){function t(){let B=!1,oe=new jt,ie=null,we=new jt(0,0,0,0);return{setMask:function(ge){ie!==ge&&!B&&(i.colorMask(ge,ge,ge,ge),ie=ge)},setLocked:function(ge){B=ge},setClear:function(ge,be,He,je,ce){ce===!0&&(ge*=je,be*=je,He*=je),oe.set(ge,be,He,je),we.equals(oe)===!1&&(i.clearColor(ge,be,He,je),we.copy(oe))},reset:function(){B=!1,ie=null,we.set(-1,0,0,0)}}}function n(){let B=!1,oe=!1,ie=null,we=null,ge=null;return{setReversed:function(be){if(oe!==be){let He=e.get("EXT_clip_control");be?He.clipControlEXT(He.LOWER_LEFT_EXT,He.ZERO_TO_ONE_EXT):He.clipControlEXT(He.LOWER_LEFT_EXT,He.NEGATIVE_ONE_TO_ONE_EXT),oe=be;let je=ge;ge=null,this.setClear(je)}},getReversed:function(){return oe},setTest:function(be){be?Me(i.DEPTH_TEST):Xe(i.DEPTH_TEST)},setMask:function(be){ie!==be&&!B&&(i.depthMask(be),ie=be)},setFunc:function(be){if(oe&&(be=Z0[be]),we!==be){switch(be){case oc:i.depthFunc(i.NEVER);break;case ac:i.depthFunc(i.ALWAYS);break;case lc:i.depthFunc(i.LESS);break;case bo:i.depthFunc(i.LEQUAL);break;case cc:i.depthFunc(i.EQUAL);break;case hc:i.depthFunc(i.GEQUAL);break;case Mo:i.depthFunc(i.GREATER);break;case uc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}we=be}},setLocked:function(be){B=be},setClear:function(be){ge!==be&&(ge=be,oe&&(be=1-be),i.clearDepth(be))},reset:function(){B=!1,ie=null,we=null,ge=null,oe=!1}}}function s(){let B=!1,oe=null,ie=null,we=null,ge=null,be=null,He=null,je=null,ce=null;return{setTest:function(ke){B||(ke?Me(i.STENCIL_TEST):Xe(i.STENCIL_TEST))},setMask:function(ke){oe!==ke&&!B&&(i.stencilMask(ke),oe=ke)},setFunc:function(ke,Qe,Ce){(ie!==ke||we!==Qe||ge!==Ce)&&(i.stencilFunc(ke,Qe,Ce),ie=ke,we=Qe,ge=Ce)},setOp:function(ke,Qe,Ce){(be!==ke||He!==Qe||je!==Ce)&&(i.stencilOp(ke,Qe,Ce),be=ke,He=Qe,je=Ce)},setLocked:function(ke){B=ke},setClear:function(ke){ce!==ke&&(i.clearStencil(ke),ce=ke)},reset:function(){B=!1,oe=null,ie=null,we=null,ge=null,be=null,He=null,je=null,ce=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,g=[],v=null,m=!1,p=null,x=null,M=null,b=null,C=null,E=null,y=null,S=new _t(0,0,0),U=0,L=!1,R=null,O=null,V=null,P=null,H=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),k=!1,re=0,q=i.getParameter(i.VERSION);q.indexOf("WebGL")!==-1?(re=parseFloat(/^WebGL (\d)/.exec(q)[1]),k=re>=1):q.indexOf("OpenGL ES")!==-1&&(re=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),k=re>=2);let j=null,te={},de=i.getParameter(i.SCISSOR_BOX),ue=i.getParameter(i.VIEWPORT),ee=new jt().fromArray(de),me=new jt().fromArray(ue);function ye(B,oe,ie,we){let ge=new Uint8Array(4),be=i.createTexture();i.bindTexture(B,be),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let He=0;He<ie;He++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(oe,0,i.RGBA,1,1,we,0,i.RGBA,i.UNSIGNED_BYTE,ge):i.texImage2D(oe+He,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ge);return be}let Ae={};Ae[i.TEXTURE_2D]=ye(i.TEXTURE_2D,i.TEXTURE_2D,1),Ae[i.TEXTURE_CUBE_MAP]=ye(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[i.TEXTURE_2D_ARRAY]=ye(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ae[i.TEXTURE_3D]=ye(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Me(i.DEPTH_TEST),o.setFunc(bo),cn(!1),Nt(kd),Me(i.CULL_FACE),$t(wr);function Me(B){h[B]!==!0&&(i.enable(B),h[B]=!0)}function Xe(B){h[B]!==!1&&(i.disable(B),h[B]=!1)}function rt(B,oe){return d[B]!==oe?(i.bindFramebuffer(B,oe),d[B]=oe,B===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=oe),B===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=oe),!0):!1}function Ge(B,oe){let ie=g,we=!1;if(B){ie=f.get(oe),ie===void 0&&(ie=[],f.set(oe,ie));let ge=B.textures;if(ie.length!==ge.length||ie[0]!==i.COLOR_ATTACHMENT0){for(let be=0,He=ge.length;be<He;be++)ie[be]=i.COLOR_ATTACHMENT0+be;ie.length=ge.length,we=!0}}else ie[0]!==i.BACK&&(ie[0]=i.BACK,we=!0);we&&i.drawBuffers(ie)}function ut(B){return v!==B?(i.useProgram(B),v=B,!0):!1}let lt={[Er]:i.FUNC_ADD,[y0]:i.FUNC_SUBTRACT,[x0]:i.FUNC_REVERSE_SUBTRACT};lt[_0]=i.MIN,lt[b0]=i.MAX;let it={[M0]:i.ZERO,[S0]:i.ONE,[w0]:i.SRC_COLOR,[Gd]:i.SRC_ALPHA,[P0]:i.SRC_ALPHA_SATURATE,[C0]:i.DST_COLOR,[T0]:i.DST_ALPHA,[E0]:i.ONE_MINUS_SRC_COLOR,[Hd]:i.ONE_MINUS_SRC_ALPHA,[R0]:i.ONE_MINUS_DST_COLOR,[A0]:i.ONE_MINUS_DST_ALPHA,[I0]:i.CONSTANT_COLOR,[L0]:i.ONE_MINUS_CONSTANT_COLOR,[N0]:i.CONSTANT_ALPHA,[D0]:i.ONE_MINUS_CONSTANT_ALPHA};function $t(B,oe,ie,we,ge,be,He,je,ce,ke){if(B===wr){m===!0&&(Xe(i.BLEND),m=!1);return}if(m===!1&&(Me(i.BLEND),m=!0),B!==v0){if(B!==p||ke!==L){if((x!==Er||C!==Er)&&(i.blendEquation(i.FUNC_ADD),x=Er,C=Er),ke)switch(B){case Do:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Bd:i.blendFunc(i.ONE,i.ONE);break;case zd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Vd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:tt("WebGLState: Invalid blending: ",B);break}else switch(B){case Do:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Bd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case zd:tt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Vd:tt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:tt("WebGLState: Invalid blending: ",B);break}M=null,b=null,E=null,y=null,S.set(0,0,0),U=0,p=B,L=ke}return}ge=ge||oe,be=be||ie,He=He||we,(oe!==x||ge!==C)&&(i.blendEquationSeparate(lt[oe],lt[ge]),x=oe,C=ge),(ie!==M||we!==b||be!==E||He!==y)&&(i.blendFuncSeparate(it[ie],it[we],it[be],it[He]),M=ie,b=we,E=be,y=He),(je.equals(S)===!1||ce!==U)&&(i.blendColor(je.r,je.g,je.b,ce),S.copy(je),U=ce),p=B,L=!1}function Bt(B,oe){B.side===os?Xe(i.CULL_FACE):Me(i.CULL_FACE);let ie=B.side===jn;oe&&(ie=!ie),cn(ie),B.blending===Do&&B.transparent===!1?$t(wr):$t(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let we=B.stencilWrite;a.setTest(we),we&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),bt(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Me(i.SAMPLE_ALPHA_TO_COVERAGE):Xe(i.SAMPLE_ALPHA_TO_COVERAGE)}function cn(B){R!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),R=B)}function Nt(B){B!==p0?(Me(i.CULL_FACE),B!==O&&(B===kd?i.cullFace(i.BACK):B===m0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Xe(i.CULL_FACE),O=B}function Sn(B){B!==V&&(k&&i.lineWidth(B),V=B)}function bt(B,oe,ie){B?(Me(i.POLYGON_OFFSET_FILL),(P!==oe||H!==ie)&&(P=oe,H=ie,o.getReversed()&&(oe=-oe,ie=-ie),i.polygonOffset(oe,ie))):Xe(i.POLYGON_OFFSET_FILL)}function vn(B){B?Me(i.SCISSOR_TEST):Xe(i.SCISSOR_TEST)}function Qt(B){B===void 0&&(B=i.TEXTURE0+Y-1),j!==B&&(i.activeTexture(B),j=B)}function hn(B,oe,ie){ie===void 0&&(j===null?ie=i.TEXTURE0+Y-1:ie=j);let we=te[ie];we===void 0&&(we={type:void 0,texture:void 0},te[ie]=we),(we.type!==B||we.texture!==oe)&&(j!==ie&&(i.activeTexture(ie),j=ie),i.bindTexture(B,oe||Ae[B]),we.type=B,we.texture=oe)}function z(){let B=te[j];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Re(){try{i.compressedTexImage2D(...arguments)}catch(B){tt("WebGLState:",B)}}function Je(){try{i.compressedTexImage3D(...arguments)}catch(B){tt("WebGLState:",B)}}function ot(){try{i.texSubImage2D(...arguments)}catch(B){tt("WebGLState:",B)}}function Se(){try{i.texSubImage3D(...arguments)}catch(B){tt("WebGLState:",B)}}function Ft(){try{i.compressedTexSubImage2D(...arguments)}catch(B){tt("WebGLState:",B)}}function Ve(){try{i.compressedTexSubImage3D(...arguments)}catch(B){tt("WebGLState:",B)}}function $e(){try{i.texStorage2D(...arguments)}catch(B){tt("WebGLState:",B)}}function I(){try{i.texStorage3D(...arguments)}catch(B){tt("WebGLState:",B)}}function w(){try{i.texImage2D(...arguments)}catch(B){tt("WebGLState:",B)}}function $(){try{i.texImage3D(...arguments)}catch(B){tt("WebGLState:",B)}}function he(B){return u[B]!==void 0?u[B]:i.getParameter(B)}function ae(B,oe){u[B]!==oe&&(i.pixelStorei(B,oe),u[B]=oe)}function ve(B){ee.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),ee.copy(B))}function xe(B){me.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),me.copy(B))}function ne(B,oe){let ie=c.get(oe);ie===void 0&&(ie=new WeakMap,c.set(oe,ie));let we=ie.get(B);we===void 0&&(we=i.getUniformBlockIndex(oe,B.name),i.uniformBlockBinding(oe,we,we),ie.set(B,we))}function se(B,oe,ie){let ge=c.get(oe).get(B);l[ge]!==ie&&(i.bindBufferBase(i.UNIFORM_BUFFER,ge,ie),l[ge]=ie)}function pe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},j=null,te={},d={},l={},f=new WeakMap,g=[],v=null,m=!1,p=null,x=null,M=null,b=null,C=null,E=null,y=null,S=new _t(0,0,0),U=0,L=!1,R=null,O=null,V=null,P=null,H=null,ee.set(0,0,i.canvas.width,i.canvas.height),me.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Me,disable:Xe,bindFramebuffer:rt,drawBuffers:Ge,useProgram:ut,setBlending:$t,setMaterial:Bt,setFlipSided:cn,setCullFace:Nt,setLineWidth:Sn,setPolygonOffset:bt,setScissorTest:vn,activeTexture:Qt,bindTexture:hn,unbindTexture:z,compressedTexImage2D:Re,compressedTexImage3D:Je,texImage2D:w,texImage3D:$,pixelStorei:ae,getParameter:he,updateUBOMapping:ne,uniformBlockBinding:se,texStorage2D:$e,texStorage3D:I,texSubImage2D:ot,texSubImage3D:Se,compressedTexSubImage2D:Ft,compressedTexSubImage3D:Ve,scissor:ve,viewport:xe,reset:pe}}function NE(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new xt,h=new WeakMap,u=new Set,d,f=new WeakMap,g=new Set,v=new FinalizationRegistry(I=>g.delete(I)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(I,w){return m?new OffscreenCanvas(I,w):Ea("canvas")}function x(I,w,$){let he=1,ae=$e(I);if((ae.width>$||ae.height>$)&&(he=$/Math.max(ae.width,ae.height)),he<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let ve=Math.floor(he*ae.width),xe=Math.floor(he*ae.height);d===void 0&&(d=p(ve,xe));let ne=w?p(ve,xe):d;return ne.width=ve,ne.height=xe,ne.getContext("2d").drawImage(I,0,0,ve,xe),Ze("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+ve+"x"+xe+")."),ne}else return"data"in I&&Ze("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),I;return I}function M(I){return I.generateMipmaps}function b(I){i.generateMipmap(I)}function C(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(I,w,$,he,ae,ve=!1){if(I!==null){if(i[I]!==void 0)return i[I];Ze("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let xe;he&&(xe=e.get("EXT_texture_norm16"),xe||Ze("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=w;if(w===i.RED&&($===i.FLOAT&&(ne=i.R32F),$===i.HALF_FLOAT&&(ne=i.R16F),$===i.UNSIGNED_BYTE&&(ne=i.R8),$===i.UNSIGNED_SHORT&&xe&&(ne=xe.R16_EXT),$===i.SHORT&&xe&&(ne=xe.R16_SNORM_EXT)),w===i.RED_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.R8UI),$===i.UNSIGNED_SHORT&&(ne=i.R16UI),$===i.UNSIGNED_INT&&(ne=i.R32UI),$===i.BYTE&&(ne=i.R8I),$===i.SHORT&&(ne=i.R16I),$===i.INT&&(ne=i.R32I)),w===i.RG&&($===i.FLOAT&&(ne=i.RG32F),$===i.HALF_FLOAT&&(ne=i.RG16F),$===i.UNSIGNED_BYTE&&(ne=i.RG8),$===i.UNSIGNED_SHORT&&xe&&(ne=xe.RG16_EXT),$===i.SHORT&&xe&&(ne=xe.RG16_SNORM_EXT)),w===i.RG_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RG8UI),$===i.UNSIGNED_SHORT&&(ne=i.RG16UI),$===i.UNSIGNED_INT&&(ne=i.RG32UI),$===i.BYTE&&(ne=i.RG8I),$===i.SHORT&&(ne=i.RG16I),$===i.INT&&(ne=i.RG32I)),w===i.RGB_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RGB8UI),$===i.UNSIGNED_SHORT&&(ne=i.RGB16UI),$===i.UNSIGNED_INT&&(ne=i.RGB32UI),$===i.BYTE&&(ne=i.RGB8I),$===i.SHORT&&(ne=i.RGB16I),$===i.INT&&(ne=i.RGB32I)),w===i.RGBA_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RGBA8UI),$===i.UNSIGNED_SHORT&&(ne=i.RGBA16UI),$===i.UNSIGNED_INT&&(ne=i.RGBA32UI),$===i.BYTE&&(ne=i.RGBA8I),$===i.SHORT&&(ne=i.RGBA16I),$===i.INT&&(ne=i.RGBA32I)),w===i.RGB&&($===i.UNSIGNED_SHORT&&xe&&(ne=xe.RGB16_EXT),$===i.SHORT&&xe&&(ne=xe.RGB16_SNORM_EXT),$===i.UNSIGNED_INT_5_9_9_9_REV&&(ne=i.RGB9_E5),$===i.UNSIGNED_INT_10F_11F_11F_REV&&(ne=i.R11F_G11F_B10F)),w===i.RGBA){let se=ve?Sa:vt.getTransfer(ae);$===i.FLOAT&&(ne=i.RGBA32F),$===i.HALF_FLOAT&&(ne=i.RGBA16F),$===i.UNSIGNED_BYTE&&(ne=se===Rt?i.SRGB8_ALPHA8:i.RGBA8),$===i.UNSIGNED_SHORT&&xe&&(ne=xe.RGBA16_EXT),$===i.SHORT&&xe&&(ne=xe.RGBA16_SNORM_EXT),$===i.UNSIGNED_SHORT_4_4_4_4&&(ne=i.RGBA4),$===i.UNSIGNED_SHORT_5_5_5_1&&(ne=i.RGB5_A1)}return(ne===i.R16F||ne===i.R32F||ne===i.RG16F||ne===i.RG32F||ne===i.RGBA16F||ne===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function y(I,w){let $;return I?w===null||w===ki||w===Ar?$=i.DEPTH24_STENCIL8:w===Bi?$=i.DEPTH32F_STENCIL8:w===Fo&&($=i.DEPTH24_STENCIL8,Ze("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===ki||w===Ar?$=i.DEPTH_COMPONENT24:w===Bi?$=i.DEPTH_COMPONENT32F:w===Fo&&($=i.DEPTH_COMPONENT16),$}function S(I,w){return M(I)===!0||I.isFramebufferTexture&&I.minFilter!==In&&I.minFilter!==Dn?Math.log2(Math.max(w.width,w.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?w.mipmaps.length:1}function U(I){let w=new WeakRef(I);n.get(I).__ref=w,g.add(w),v.register(I,w,w)}function L(I){let w=n.get(I).__ref;w!==void 0&&(g.delete(w),v.unregister(w))}function R(I){V(I.target)}function O(I){P(I.target)}function V(I){I.removeEventListener("dispose",R),L(I),Y(I),I.isVideoTexture&&h.delete(I),I.isHTMLTexture&&u.delete(I)}function P(I){I.removeEventListener("dispose",O),L(I),re(I)}function H(){for(let I of g){let w=I.deref();w!==void 0&&(w.isRenderTarget===!0?P(w):V(w))}g.clear(),u.clear()}function Y(I){let w=n.get(I);if(w.__webglInit===void 0)return;let $=I.source,he=f.get($);if(he){let ae=he[w.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&k(I),Object.keys(he).length===0&&f.delete($)}n.remove(I)}function k(I){let w=n.get(I);i.deleteTexture(w.__webglTexture);let $=I.source,he=f.get($);delete he[w.__cacheKey],o.memory.textures--}function re(I){let w=n.get(I);w.__depthDisposeCallback&&w.__depthDisposeCallback();let $=I.depthTexture;if($&&$.renderTarget===I&&V($),I.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(w.__webglFramebuffer[ae]))for(let ve=0;ve<w.__webglFramebuffer[ae].length;ve++)i.deleteFramebuffer(w.__webglFramebuffer[ae][ve]);else i.deleteFramebuffer(w.__webglFramebuffer[ae]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[ae])}else{if(Array.isArray(w.__webglFramebuffer))for(let ae=0;ae<w.__webglFramebuffer.length;ae++)i.deleteFramebuffer(w.__webglFramebuffer[ae]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let ae=0;ae<w.__webglColorRenderbuffer.length;ae++)w.__webglColorRenderbuffer[ae]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[ae]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let he=I.textures;for(let ae=0,ve=he.length;ae<ve;ae++){let xe=n.get(he[ae]);xe.__webglTexture&&(i.deleteTexture(xe.__webglTexture),o.memory.textures--),n.remove(he[ae])}n.remove(I)}let q=0;function j(){q=0}function te(){return q}function de(I){q=I}function ue(){let I=q;return I>=s.maxTextures&&Ze("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,I}function ee(I){let w=[];return w.push(I.wrapS),w.push(I.wrapT),w.push(I.wrapR||0),w.push(I.magFilter),w.push(I.minFilter),w.push(I.anisotropy),w.push(I.internalFormat),w.push(I.format),w.push(I.type),w.push(I.generateMipmaps),w.push(I.mipmapsAutoUpdate),w.push(I.premultiplyAlpha),w.push(I.flipY),w.push(I.unpackAlignment),w.push(I.colorSpace),w.join()}function me(I,w){let $=n.get(I);if(I.isVideoTexture&&Ft(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&$.__version!==I.version){let he=I.image;if(he===null)Ze("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)Ze("WebGLRenderer: Texture marked for update but image is incomplete");else{Bt($,I,w);return}}else I.isExternalTexture&&($.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,$.__webglTexture,i.TEXTURE0+w)}function ye(I,w){let $=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&$.__version!==I.version){Bt($,I,w);return}else I.isExternalTexture&&($.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,$.__webglTexture,i.TEXTURE0+w)}function Ae(I,w){let $=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&$.__version!==I.version){Bt($,I,w);return}t.bindTexture(i.TEXTURE_3D,$.__webglTexture,i.TEXTURE0+w)}function Me(I,w){let $=n.get(I);if(I.version>0&&$.__version!==I.version){cn($,I,w);return}t.bindTexture(i.TEXTURE_CUBE_MAP,$.__webglTexture,i.TEXTURE0+w)}let Xe={[dc]:i.REPEAT,[ss]:i.CLAMP_TO_EDGE,[fc]:i.MIRRORED_REPEAT},rt={[In]:i.NEAREST,[O0]:i.NEAREST_MIPMAP_NEAREST,[Oa]:i.NEAREST_MIPMAP_LINEAR,[Dn]:i.LINEAR,[Hc]:i.LINEAR_MIPMAP_NEAREST,[Oi]:i.LINEAR_MIPMAP_LINEAR},Ge={[V0]:i.NEVER,[hf]:i.ALWAYS,[G0]:i.LESS,[lf]:i.LEQUAL,[H0]:i.EQUAL,[cf]:i.GEQUAL,[W0]:i.GREATER,[X0]:i.NOTEQUAL};function ut(I,w){if(w.type===Bi&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===Dn||w.magFilter===Hc||w.magFilter===Oa||w.magFilter===Oi||w.minFilter===Dn||w.minFilter===Hc||w.minFilter===Oa||w.minFilter===Oi)&&Ze("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,Xe[w.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,Xe[w.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,Xe[w.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,rt[w.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,rt[w.minFilter]),w.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,Ge[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===In||w.minFilter!==Oa&&w.minFilter!==Oi||w.type===Bi&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");i.texParameterf(I,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function lt(I,w){let $=!1;I.__webglInit===void 0&&(I.__webglInit=!0,w.addEventListener("dispose",R),U(w));let he=w.source,ae=f.get(he);ae===void 0&&(ae={},f.set(he,ae));let ve=ee(w);if(ve!==I.__cacheKey){ae[ve]===void 0&&(ae[ve]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ae[ve].usedTimes++;let xe=ae[I.__cacheKey];xe!==void 0&&(ae[I.__cacheKey].usedTimes--,xe.usedTimes===0&&k(w)),I.__cacheKey=ve,I.__webglTexture=ae[ve].texture}return $}function it(I,w,$){return Math.floor(Math.floor(I/$)/w)}function $t(I,w,$,he){let ve=I.updateRanges;if(ve.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,$,he,w.data);else{ve.sort((B,oe)=>B.start-oe.start);let xe=0;for(let B=1;B<ve.length;B++){let oe=ve[xe],ie=ve[B],we=oe.start+oe.count,ge=it(ie.start,w.width,4),be=it(oe.start,w.width,4);ie.start<=we+1&&ge===be&&it(ie.start+ie.count-1,w.width,4)===ge?oe.count=Math.max(oe.count,ie.start+ie.count-oe.start):(++xe,ve[xe]=ie)}ve.length=xe+1;let ne=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),pe=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let B=0,oe=ve.length;B<oe;B++){let ie=ve[B],we=Math.floor(ie.start/4),ge=Math.ceil(ie.count/4),be=we%w.width,He=Math.floor(we/w.width),je=ge,ce=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,be),t.pixelStorei(i.UNPACK_SKIP_ROWS,He),t.texSubImage2D(i.TEXTURE_2D,0,be,He,je,ce,$,he,w.data)}I.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ne),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,pe)}}function Bt(I,w,$){let he=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(he=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(he=i.TEXTURE_3D);let ae=lt(I,w),ve=w.source;t.bindTexture(he,I.__webglTexture,i.TEXTURE0+$);let xe=n.get(ve);if(ve.version!==xe.__version||ae===!0){if(t.activeTexture(i.TEXTURE0+$),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ce=vt.getPrimaries(vt.workingColorSpace),ke=w.colorSpace===Cs?null:vt.getPrimaries(w.colorSpace),Qe=w.colorSpace===Cs||ce===ke?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Qe)}t.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment);let se=x(w.image,!1,s.maxTextureSize);se=Ve(w,se);let pe=r.convert(w.format,w.colorSpace),B=r.convert(w.type),oe=E(w.internalFormat,pe,B,w.normalized,w.colorSpace,w.isVideoTexture);ut(he,w);let ie,we=w.mipmaps,ge=w.isVideoTexture!==!0,be=xe.__version===void 0||ae===!0,He=ve.dataReady,je=S(w,se);if(w.isDepthTexture)oe=y(w.format===As,w.type),be&&(ge?t.texStorage2D(i.TEXTURE_2D,1,oe,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,oe,se.width,se.height,0,pe,B,null));else if(w.isDataTexture)if(we.length>0){ge&&be&&t.texStorage2D(i.TEXTURE_2D,je,oe,we[0].width,we[0].height);for(let ce=0,ke=we.length;ce<ke;ce++)ie=we[ce],ge?He&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,ie.width,ie.height,pe,B,ie.data):t.texImage2D(i.TEXTURE_2D,ce,oe,ie.width,ie.height,0,pe,B,ie.data);w.generateMipmaps=!1}else ge?(be&&t.texStorage2D(i.TEXTURE_2D,je,oe,se.width,se.height),He&&$t(w,se,pe,B)):t.texImage2D(i.TEXTURE_2D,0,oe,se.width,se.height,0,pe,B,se.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){ge&&be&&t.texStorage3D(i.TEXTURE_2D_ARRAY,je,oe,we[0].width,we[0].height,se.depth);for(let ce=0,ke=we.length;ce<ke;ce++)if(ie=we[ce],w.format!==Vi)if(pe!==null)if(ge){if(He)if(w.layerUpdates.size>0){let Qe=vf(ie.width,ie.height,w.format,w.type);for(let Ce of w.layerUpdates){let at=ie.data.subarray(Ce*Qe/ie.data.BYTES_PER_ELEMENT,(Ce+1)*Qe/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,Ce,ie.width,ie.height,1,pe,at)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,0,ie.width,ie.height,se.depth,pe,ie.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ce,oe,ie.width,ie.height,se.depth,0,ie.data,0,0);else Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?He&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,0,ie.width,ie.height,se.depth,pe,B,ie.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ce,oe,ie.width,ie.height,se.depth,0,pe,B,ie.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{ge&&be&&t.texStorage2D(i.TEXTURE_2D,je,oe,we[0].width,we[0].height);for(let ce=0,ke=we.length;ce<ke;ce++)ie=we[ce],w.format!==Vi?pe!==null?ge?He&&t.compressedTexSubImage2D(i.TEXTURE_2D,ce,0,0,ie.width,ie.height,pe,ie.data):t.compressedTexImage2D(i.TEXTURE_2D,ce,oe,ie.width,ie.height,0,ie.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?He&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,ie.width,ie.height,pe,B,ie.data):t.texImage2D(i.TEXTURE_2D,ce,oe,ie.width,ie.height,0,pe,B,ie.data)}else if(w.isDataArrayTexture)if(ge){if(be&&t.texStorage3D(i.TEXTURE_2D_ARRAY,je,oe,se.width,se.height,se.depth),He)if(w.layerUpdates.size>0){let ce=vf(se.width,se.height,w.format,w.type);for(let ke of w.layerUpdates){let Qe=se.data.subarray(ke*ce/se.data.BYTES_PER_ELEMENT,(ke+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ke,se.width,se.height,1,pe,B,Qe)}w.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,B,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,oe,se.width,se.height,se.depth,0,pe,B,se.data);else if(w.isData3DTexture)ge?(be&&t.texStorage3D(i.TEXTURE_3D,je,oe,se.width,se.height,se.depth),He&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,B,se.data)):t.texImage3D(i.TEXTURE_3D,0,oe,se.width,se.height,se.depth,0,pe,B,se.data);else if(w.isFramebufferTexture){if(be)if(ge)t.texStorage2D(i.TEXTURE_2D,je,oe,se.width,se.height);else{let ce=se.width,ke=se.height;for(let Qe=0;Qe<je;Qe++)t.texImage2D(i.TEXTURE_2D,Qe,oe,ce,ke,0,pe,B,null),ce>>=1,ke>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in i){let ce=i.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),u.add(w),ce.onpaint=ke=>{let Qe=ke.changedElements;for(let Ce of u)Qe.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let Qe=i.RGBA,Ce=i.RGBA,at=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Qe,Ce,at,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&be){let ce=$e(we[0]);t.texStorage2D(i.TEXTURE_2D,je,oe,ce.width,ce.height)}for(let ce=0,ke=we.length;ce<ke;ce++)ie=we[ce],ge?He&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,pe,B,ie):t.texImage2D(i.TEXTURE_2D,ce,oe,pe,B,ie);w.generateMipmaps=!1}else if(ge){if(be){let ce=$e(se);t.texStorage2D(i.TEXTURE_2D,je,oe,ce.width,ce.height)}He&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,pe,B,se)}else t.texImage2D(i.TEXTURE_2D,0,oe,pe,B,se);M(w)&&w.mipmapsAutoUpdate===!0&&b(he),xe.__version=ve.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function cn(I,w,$){if(w.image.length!==6)return;let he=lt(I,w),ae=w.source;t.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+$);let ve=n.get(ae);if(ae.version!==ve.__version||he===!0){t.activeTexture(i.TEXTURE0+$);let xe=vt.getPrimaries(vt.workingColorSpace),ne=w.colorSpace===Cs?null:vt.getPrimaries(w.colorSpace),se=w.colorSpace===Cs||xe===ne?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=w.isCompressedTexture||w.image[0].isCompressedTexture,B=w.image[0]&&w.image[0].isDataTexture,oe=[];for(let Ce=0;Ce<6;Ce++)!pe&&!B?oe[Ce]=x(w.image[Ce],!0,s.maxCubemapSize):oe[Ce]=B?w.image[Ce].image:w.image[Ce],oe[Ce]=Ve(w,oe[Ce]);let ie=oe[0],we=r.convert(w.format,w.colorSpace),ge=r.convert(w.type),be=E(w.internalFormat,we,ge,w.normalized,w.colorSpace),He=w.isVideoTexture!==!0,je=ve.__version===void 0||he===!0,ce=ae.dataReady,ke=S(w,ie);ut(i.TEXTURE_CUBE_MAP,w);let Qe;if(w.isDepthTexture){if(be=y(w.format===As,w.type),je)if(He)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,be,ie.width,ie.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,ie.width,ie.height,0,we,ge,null)}else if(pe){He&&je&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ke,be,ie.width,ie.height);for(let Ce=0;Ce<6;Ce++){Qe=oe[Ce].mipmaps;for(let at=0;at<Qe.length;at++){let Vt=Qe[at];w.format!==Vi?we!==null?He?ce&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,0,0,Vt.width,Vt.height,we,Vt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,be,Vt.width,Vt.height,0,Vt.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):He?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,0,0,Vt.width,Vt.height,we,ge,Vt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,be,Vt.width,Vt.height,0,we,ge,Vt.data)}}}else{if(Qe=w.mipmaps,He&&je){Qe.length>0&&ke++;let Ce=$e(oe[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ke,be,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(B){He?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,oe[Ce].width,oe[Ce].height,we,ge,oe[Ce].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,oe[Ce].width,oe[Ce].height,0,we,ge,oe[Ce].data);for(let at=0;at<Qe.length;at++){let Hn=Qe[at].image[Ce].image;He?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,0,0,Hn.width,Hn.height,we,ge,Hn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,be,Hn.width,Hn.height,0,we,ge,Hn.data)}}else{He?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,we,ge,oe[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,we,ge,oe[Ce]);for(let at=0;at<Qe.length;at++){let Vt=Qe[at];He?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,0,0,we,ge,Vt.image[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,be,we,ge,Vt.image[Ce])}}}M(w)&&w.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),ve.__version=ae.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function Nt(I,w,$,he,ae,ve){let xe=r.convert($.format,$.colorSpace),ne=r.convert($.type),se=E($.internalFormat,xe,ne,$.normalized,$.colorSpace),pe=n.get(w),B=n.get($);if(B.__renderTarget=w,!pe.__hasExternalTextures){let oe=Math.max(1,w.width>>ve),ie=Math.max(1,w.height>>ve);ae===i.TEXTURE_3D||ae===i.TEXTURE_2D_ARRAY?t.texImage3D(ae,ve,se,oe,ie,w.depth,0,xe,ne,null):t.texImage2D(ae,ve,se,oe,ie,0,xe,ne,null)}t.bindFramebuffer(i.FRAMEBUFFER,I),Se(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,he,ae,B.__webglTexture,0,ot(w)):(ae===i.TEXTURE_2D||ae>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,he,ae,B.__webglTexture,ve),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Sn(I,w,$){if(i.bindRenderbuffer(i.RENDERBUFFER,I),w.depthBuffer){let he=w.depthTexture,ae=he&&he.isDepthTexture?he.type:null,ve=y(w.stencilBuffer,ae),xe=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Se(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ot(w),ve,w.width,w.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,ot(w),ve,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,ve,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,xe,i.RENDERBUFFER,I)}else{let he=w.textures;for(let ae=0;ae<he.length;ae++){let ve=he[ae],xe=r.convert(ve.format,ve.colorSpace),ne=r.convert(ve.type),se=E(ve.internalFormat,xe,ne,ve.normalized,ve.colorSpace);Se(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ot(w),se,w.width,w.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,ot(w),se,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,se,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function bt(I,w,$){let he=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,I),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=n.get(w.depthTexture);ae.__renderTarget=w;let ve=he?w.depthTexture.image[0]:w.depthTexture.image;(!ae.__webglTexture||ve.width!==w.width||ve.height!==w.height)&&(ve.width=w.width,ve.height=w.height,w.depthTexture.needsUpdate=!0),he?Me(w.depthTexture,0):me(w.depthTexture,0);let xe=ae.__webglTexture,ne=ot(w),se=he?i.TEXTURE_CUBE_MAP_POSITIVE_X+$:i.TEXTURE_2D,pe=w.depthTexture.format===As?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(w.depthTexture.format===Ss)Se(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,se,xe,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,pe,se,xe,0);else if(w.depthTexture.format===As)Se(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,se,xe,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,pe,se,xe,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function vn(I){let w=n.get(I),$=I.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==I.depthTexture){let he=I.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),he){let ae=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,he.removeEventListener("dispose",ae)};he.addEventListener("dispose",ae),w.__depthDisposeCallback=ae}w.__boundDepthTexture=he}if(I.depthTexture&&!w.__autoAllocateDepthBuffer)if($)for(let he=0;he<6;he++)bt(w.__webglFramebuffer[he],I,he);else I.texture.mipmaps.length>0?bt(w.__webglFramebuffer[0],I,0):bt(w.__webglFramebuffer,I,0);else if($){w.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[he]),w.__webglDepthbuffer[he]===void 0)w.__webglDepthbuffer[he]=i.createRenderbuffer(),Sn(w.__webglDepthbuffer[he],I,!1);else{let ae=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=w.__webglDepthbuffer[he];i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,ve)}}else if(I.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),Sn(w.__webglDepthbuffer,I,!1);else{let ae=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,ve)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Qt(I,w,$){let he=n.get(I);w!==void 0&&Nt(he.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),$!==void 0&&vn(I)}function hn(I){let w=I.texture,$=n.get(I),he=n.get(w);I.addEventListener("dispose",O),U(I);let ae=I.textures,ve=I.isWebGLCubeRenderTarget===!0,xe=ae.length>1;if(xe||(he.__webglTexture===void 0&&(he.__webglTexture=i.createTexture()),he.__version=w.version,o.memory.textures++),ve){$.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(w.mipmaps.length>0){$.__webglFramebuffer[ne]=[];for(let se=0;se<w.mipmaps.length;se++)$.__webglFramebuffer[ne][se]=i.createFramebuffer()}else $.__webglFramebuffer[ne]=i.createFramebuffer()}else{if(w.mipmaps.length>0){$.__webglFramebuffer=[];for(let ne=0;ne<w.mipmaps.length;ne++)$.__webglFramebuffer[ne]=i.createFramebuffer()}else $.__webglFramebuffer=i.createFramebuffer();if(xe)for(let ne=0,se=ae.length;ne<se;ne++){let pe=n.get(ae[ne]);pe.__webglTexture===void 0&&(pe.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&Se(I)===!1){$.__webglMultisampledFramebuffer=i.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let ne=0;ne<ae.length;ne++){let se=ae[ne];$.__webglColorRenderbuffer[ne]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,$.__webglColorRenderbuffer[ne]);let pe=r.convert(se.format,se.colorSpace),B=r.convert(se.type),oe=E(se.internalFormat,pe,B,se.normalized,se.colorSpace,I.isXRRenderTarget===!0),ie=ot(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,ie,oe,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ne,i.RENDERBUFFER,$.__webglColorRenderbuffer[ne])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&($.__webglDepthRenderbuffer=i.createRenderbuffer(),Sn($.__webglDepthRenderbuffer,I,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ve){t.bindTexture(i.TEXTURE_CUBE_MAP,he.__webglTexture),ut(i.TEXTURE_CUBE_MAP,w);for(let ne=0;ne<6;ne++)if(w.mipmaps.length>0)for(let se=0;se<w.mipmaps.length;se++)Nt($.__webglFramebuffer[ne][se],I,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,se);else Nt($.__webglFramebuffer[ne],I,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);M(w)?b(i.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(xe){for(let ne=0,se=ae.length;ne<se;ne++){let pe=ae[ne],B=n.get(pe),oe=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(oe=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(oe,B.__webglTexture),ut(oe,pe),Nt($.__webglFramebuffer,I,pe,i.COLOR_ATTACHMENT0+ne,oe,0),M(pe)&&b(oe)}t.unbindTexture()}else{let ne=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ne=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ne,he.__webglTexture),ut(ne,w),w.mipmaps.length>0)for(let se=0;se<w.mipmaps.length;se++)Nt($.__webglFramebuffer[se],I,w,i.COLOR_ATTACHMENT0,ne,se);else Nt($.__webglFramebuffer,I,w,i.COLOR_ATTACHMENT0,ne,0);M(w)?b(ne):w.mipmaps.length>0&&i.texParameteri(ne,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}I.depthBuffer&&vn(I)}function z(I){let w=I.textures;for(let $=0,he=w.length;$<he;$++){let ae=w[$];if(M(ae)&&ae.mipmapsAutoUpdate===!0){let ve=C(I),xe=n.get(ae).__webglTexture;t.bindTexture(ve,xe),b(ve),t.unbindTexture()}}}let Re=[];function Je(I){if(I.samples>0){if(Se(I)===!1){let w=I.textures,$=I.width,he=I.height,ae=i.COLOR_BUFFER_BIT,ve=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=n.get(I),ne=w.length>1;if(ne)for(let pe=0;pe<w.length;pe++)t.bindFramebuffer(i.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,xe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,xe.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,xe.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,xe.__webglFramebuffer);for(let pe=0;pe<w.length;pe++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(ae|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(ae|=i.STENCIL_BUFFER_BIT)),ne){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,xe.__webglColorRenderbuffer[pe]);let B=n.get(w[pe]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,$,he,0,0,$,he,ae,i.NEAREST),l===!0&&(Re.length=0,Re.push(i.COLOR_ATTACHMENT0+pe),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Re.push(ve),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ne)for(let pe=0;pe<w.length;pe++){t.bindFramebuffer(i.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,xe.__webglColorRenderbuffer[pe]);let B=n.get(w[pe]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,xe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,B,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,xe.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let w=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function ot(I){return Math.min(s.maxSamples,I.samples)}function Se(I){let w=n.get(I);return I.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Ft(I){let w=o.render.frame;h.get(I)!==w&&(h.set(I,w),I.update())}function Ve(I,w){let $=I.colorSpace,he=I.format,ae=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||$!==Ma&&$!==Cs&&(vt.getTransfer($)===Rt?(he!==Vi||ae!==gi)&&Ze("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):tt("WebGLTextures: Unsupported texture color space:",$)),w}function $e(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=j,this.getTextureUnits=te,this.setTextureUnits=de,this.setTexture2D=me,this.setTexture2DArray=ye,this.setTexture3D=Ae,this.setTextureCube=Me,this.rebindTextures=Qt,this.setupRenderTarget=hn,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=vn,this.setupFrameBufferTexture=Nt,this.useMultisampledRTT=Se,this.dispose=H}function DE(i,e){function t(n,s=Cs){let r,o=vt.getTransfer(s);if(n===gi)return i.UNSIGNED_BYTE;if(n===Xc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===qc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===tf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===nf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Qd)return i.BYTE;if(n===ef)return i.SHORT;if(n===Fo)return i.UNSIGNED_SHORT;if(n===Wc)return i.INT;if(n===ki)return i.UNSIGNED_INT;if(n===Bi)return i.FLOAT;if(n===zi)return i.HALF_FLOAT;if(n===sf)return i.ALPHA;if(n===rf)return i.RGB;if(n===Vi)return i.RGBA;if(n===Ss)return i.DEPTH_COMPONENT;if(n===As)return i.DEPTH_STENCIL;if(n===of)return i.RED;if(n===$c)return i.RED_INTEGER;if(n===ir)return i.RG;if(n===Yc)return i.RG_INTEGER;if(n===Jc)return i.RGBA_INTEGER;if(n===ka||n===Ba||n===za||n===Va)if(o===Rt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ka)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ba)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ka)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ba)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===za)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Va)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Zc||n===Kc||n===jc||n===Qc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Zc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Kc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===jc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Qc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===eh||n===th||n===nh||n===ih||n===sh||n===Ga||n===rh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===eh||n===th)return o===Rt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===nh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ih)return r.COMPRESSED_R11_EAC;if(n===sh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ga)return r.COMPRESSED_RG11_EAC;if(n===rh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===oh||n===ah||n===lh||n===ch||n===hh||n===uh||n===dh||n===fh||n===ph||n===mh||n===gh||n===vh||n===yh||n===xh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===oh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ah)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===lh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===ch)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===hh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===uh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===dh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===fh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ph)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===mh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===gh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===vh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===yh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===xh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===_h||n===bh||n===Mh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===_h)return o===Rt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===bh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Mh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Sh||n===wh||n===Ha||n===Eh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Sh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===wh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ha)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Eh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Ar?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var UE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,FE=`
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

}`,Tf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new La(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Fn({vertexShader:UE,fragmentShader:FE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new ln(new Sr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Af=class extends rs{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,g=null,v=typeof XRWebGLBinding<"u",m=new Tf,p={},x=t.getContextAttributes(),M=null,b=null,C=[],E=[],y=new xt,S=null,U=null,L=new Zn;L.viewport=new jt;let R=new Zn;R.viewport=new jt;let O=[L,R],V=new zc,P=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=C[ee];return me===void 0&&(me=new Eo,C[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=C[ee];return me===void 0&&(me=new Eo,C[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=C[ee];return me===void 0&&(me=new Eo,C[ee]=me),me.getHandSpace()};function Y(ee){let me=E.indexOf(ee.inputSource);if(me===-1)return;let ye=C[me];ye!==void 0&&(ye.update(ee.inputSource,ee.frame,c||o),ye.dispatchEvent({type:ee.type,data:ee.inputSource}))}function k(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",k),s.removeEventListener("inputsourceschange",re);for(let ee=0;ee<C.length;ee++){let me=E[ee];me!==null&&(E[ee]=null,C[ee].disconnect(me))}P=null,H=null,m.reset();for(let ee in p)delete p[ee];if(e.setRenderTarget(M),f=null,d=null,u=null,s=null,b=null,ue.stop(),n.isPresenting=!1,e.setPixelRatio(S),e.setSize(y.width,y.height,!1),U!==null){let ee=U.camera;ee.fov=U.fov,ee.zoom=U.zoom,ee.updateProjectionMatrix(),U=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&Ze("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&Ze("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&v&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",k),s.addEventListener("inputsourceschange",re),x.xrCompatible!==!0&&await t.makeXRCompatible(),S=e.getPixelRatio(),e.getSize(y),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ye=null,Ae=null,Me=null;x.depth&&(Me=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ye=x.stencil?As:Ss,Ae=x.stencil?Ar:ki);let Xe={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Xe),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new Kn(d.textureWidth,d.textureHeight,{format:Vi,type:gi,depthTexture:new Es(d.textureWidth,d.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,ye),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ye={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ye),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new Kn(f.framebufferWidth,f.framebufferHeight,{format:Vi,type:gi,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function re(ee){for(let me=0;me<ee.removed.length;me++){let ye=ee.removed[me],Ae=E.indexOf(ye);Ae>=0&&(E[Ae]=null,C[Ae].disconnect(ye))}for(let me=0;me<ee.added.length;me++){let ye=ee.added[me],Ae=E.indexOf(ye);if(Ae===-1){for(let Xe=0;Xe<C.length;Xe++)if(Xe>=E.length){E.push(ye),Ae=Xe;break}else if(E[Xe]===null){E[Xe]=ye,Ae=Xe;break}if(Ae===-1)break}let Me=C[Ae];Me&&Me.connect(ye)}}function q(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ye=ee.far;m.texture!==null&&(m.depthNear>0&&(me=m.depthNear),m.depthFar>0&&(ye=m.depthFar)),V.near=R.near=L.near=me,V.far=R.far=L.far=ye,(P!==V.near||H!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),P=V.near,H=V.far),V.layers.mask=ee.layers.mask|6,L.layers.mask=V.layers.mask&-5,R.layers.mask=V.layers.mask&-3;let Ae=ee.parent,Me=V.cameras;q(V,Ae);for(let Xe=0;Xe<Me.length;Xe++)q(Me[Xe],Ae);V.projectionMatrix.copy(L.projectionMatrix),V.projectionMatrixInverse.copy(L.projectionMatrixInverse),U===null&&ee.isPerspectiveCamera&&(U={camera:ee,fov:ee.fov,zoom:ee.zoom}),j(ee,V,Ae)};function j(ee,me,ye){ye===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ye.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=mc*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(V)},this.getCameraTexture=function(ee){return p[ee]};let te=null;function de(ee,me){if(h=me.getViewerPose(c||o),g=me,h!==null){let ye=h.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Ae=!1;ye.length!==V.cameras.length&&(V.cameras.length=0,Ae=!0);for(let Ge=0;Ge<ye.length;Ge++){let ut=ye[Ge],lt=null;if(f!==null)lt=f.getViewport(ut);else{let $t=u.getViewSubImage(d,ut);lt=$t.viewport,Ge===0&&(e.setRenderTargetTextures(b,$t.colorTexture,$t.depthStencilTexture),e.setRenderTarget(b))}let it=O[Ge];it===void 0&&(it=new Zn,it.layers.enable(Ge),it.viewport=new jt,O[Ge]=it),it.matrix.fromArray(ut.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(ut.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(lt.x,lt.y,lt.width,lt.height),Ge===0&&(V.matrix.copy(it.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Ae===!0&&V.cameras.push(it)}let Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){u=n.getBinding();let Ge=u.getDepthInformation(ye[0]);Ge&&Ge.isValid&&Ge.texture&&m.init(Ge,s.renderState)}if(Me&&Me.includes("camera-access")&&v){e.state.unbindTexture(),u=n.getBinding();for(let Ge=0;Ge<ye.length;Ge++){let ut=ye[Ge].camera;if(ut){let lt=p[ut];lt||(lt=new La,p[ut]=lt);let it=u.getCameraImage(ut);lt.sourceTexture=it}}}}for(let ye=0;ye<C.length;ye++){let Ae=E[ye],Me=C[ye];Ae!==null&&Me!==void 0&&Me.update(Ae,me,c||o)}te&&te(ee,me),me.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:me}),g=null}let ue=new Sv;ue.setAnimationLoop(de),this.setAnimationLoop=function(ee){te=ee},this.dispose=function(){}}},OE=new zt,Nv=new nt;Nv.set(-1,0,0,0,1,0,0,0,1);function kE(i,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,pf(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,x,M,b){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),u(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),d(m,p),p.isMeshPhysicalMaterial&&f(m,p,b)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,x,M):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===jn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===jn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let x=e.get(p),M=x.envMap,b=x.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(OE.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Nv),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,x,M){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*x,m.scale.value=M*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function u(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function d(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,x){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===jn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){let x=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function BE(i,e,t,n){let s={},r={};function o(x,M){let b=M.program;n.uniformBlockBinding(x,b,s[x.id])}function a(x,M){let b=s[x.id];b===void 0&&(g(x),b=l(x),s[x.id]=b,x.addEventListener("dispose",m));let C=M.program;n.updateUBOMapping(x,C);let E=e.render.frame;r[x.id]!==E&&(c(x),r[x.id]=E)}function l(x){let M=i.createBuffer(),b=x.__size,C=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,b,C),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(x){let M=s[x.id],b=x.uniforms,C=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let E=0,y=b.length;E<y;E++){let S=b[E];if(Array.isArray(S))for(let U=0,L=S.length;U<L;U++)h(S[U],E,U,C);else h(S,E,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(x,M,b,C){if(d(x,M,b,C)===!0){let E=x.__offset,y=x.value;if(Array.isArray(y)){let S=0;for(let U=0;U<y.length;U++){let L=y[U],R=v(L,!0);u(L,x.__data,S),S+=R.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,x.__data)}}function u(x,M,b){typeof x=="number"||typeof x=="boolean"?M[b]=x:x.isMatrix3?(M[b]=x.elements[0],M[b+1]=x.elements[1],M[b+2]=x.elements[2],M[b+3]=0,M[b+4]=x.elements[3],M[b+5]=x.elements[4],M[b+6]=x.elements[5],M[b+7]=0,M[b+8]=x.elements[6],M[b+9]=x.elements[7],M[b+10]=x.elements[8],M[b+11]=0):ArrayBuffer.isView(x)?M.set(x.subarray(0,M.length-b),b):x.toArray(M,b)}function d(x,M,b,C){let E=x.value,y=M+"_"+b;if(Array.isArray(E)){C[y]===void 0&&(C[y]=[]);let S=C[y],U=!1;for(let L=0;L<E.length;L++)f(E[L],S,L)===!0&&(U=!0);return U}return f(E,C,y)}function f(x,M,b){if(M[b]===void 0)return typeof x=="number"||typeof x=="boolean"?M[b]=x:ArrayBuffer.isView(x)?M[b]=x.slice():M[b]=x.clone(),!0;{let C=M[b];if(typeof x=="number"||typeof x=="boolean"){if(C!==x)return M[b]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(C.equals(x)===!1)return C.copy(x),!0}}return!1}function g(x){let M=x.uniforms,b=0,C=16;for(let y=0,S=M.length;y<S;y++){let U=Array.isArray(M[y])?M[y]:[M[y]];for(let L=0,R=U.length;L<R;L++){let O=U[L],V=Array.isArray(O.value)?O.value:[O.value],P=Array.isArray(M[y])||Array.isArray(O.value),H=b;for(let k=0,re=V.length;k<re;k++){let q=V[k],j=v(q,P),te=b%C,de=te%j.boundary,ue=te+de;b+=de,ue!==0&&C-ue<j.storage&&(b+=C-ue),k===0&&(H=b),b+=j.storage}let Y=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new Y((b-H)/Float32Array.BYTES_PER_ELEMENT),O.__offset=H}}let E=b%C;return E>0&&(b+=C-E),x.__size=b,x.__cache={},this}function v(x,M){let b={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(b.boundary=4,b.storage=4):x.isVector2?(b.boundary=8,b.storage=8):x.isVector3||x.isColor?(b.boundary=16,b.storage=12):x.isVector4?(b.boundary=16,b.storage=16):x.isMatrix3?(b.boundary=16,b.storage=48):x.isMatrix4?(b.boundary=16,b.storage=64):x.isTexture?Ze("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(b.boundary=16,b.storage=x.byteLength):Ze("WebGLRenderer: Unsupported uniform value type.",x),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(x){let M=x.target;M.removeEventListener("dispose",m),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function p(){for(let x in s)i.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:p}}var zE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ls=null;function VE(){return ls===null&&(ls=new _c(zE,16,16,ir,zi),ls.name="DFG_LUT",ls.minFilter=Dn,ls.magFilter=Dn,ls.wrapS=ss,ls.wrapT=ss,ls.generateMipmaps=!1,ls.needsUpdate=!0),ls}var Ph=class{constructor(e={}){let{canvas:t=$0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=gi}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let v=f,m=new Set([Jc,Yc,$c]),p=new Set([gi,ki,Fo,Ar,Xc,qc]),x=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,E=null,y=[],S=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=as,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,R=!1,O=null,V=null,P=null,H=null;this._outputColorSpace=di;let Y=0,k=0,re=null,q=-1,j=null,te=new jt,de=new jt,ue=null,ee=new _t(0),me=0,ye=t.width,Ae=t.height,Me=1,Xe=null,rt=null,Ge=new jt(0,0,ye,Ae),ut=new jt(0,0,ye,Ae),lt=!1,it=new Mr,$t=new bc,Bt=!1,cn=!1,Nt=new zt,Sn=new W,bt=new jt,vn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qt=!1;function hn(){return re===null?Me:1}let z=n;function Re(A,G){return t.getContext(A,G)}let Je,ot,Se,Ft,Ve,$e,I,w,$,he,ae,ve,xe,ne,se,pe,B,oe,ie,we,ge,be,He;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",Qe,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),z===null){let G="webgl2";if(z=Re(G,A),z===null)throw Re(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}je()}catch(A){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),tt("WebGLRenderer: "+A.message),A}function je(){Je=new jw(z),Je.init(),ge=new DE(z,Je),ot=new Vw(z,Je,e,ge),Se=new LE(z,Je),ot.reversedDepthBuffer&&d&&Se.buffers.depth.setReversed(!0),V=z.createFramebuffer(),P=z.createFramebuffer(),H=z.createFramebuffer(),Ft=new t1(z),Ve=new yE,$e=new NE(z,Je,Se,Ve,ot,ge,Ft),I=new Kw(L),w=new iM(z),be=new Bw(z,w),$=new Qw(z,w,Ft,be),he=new i1(z,$,w,be,Ft),oe=new n1(z,ot,$e),se=new Gw(Ve),ae=new vE(L,I,Je,ot,be,se),ve=new kE(L,Ve),xe=new _E,ne=new TE(Je),B=new kw(L,I,Se,he,g,l),pe=new IE(L,he,ot),He=new BE(z,Ft,ot,Se),ie=new zw(z,Je,Ft),we=new e1(z,Je,Ft),Ft.programs=ae.programs,L.capabilities=ot,L.extensions=Je,L.properties=Ve,L.renderLists=xe,L.shadowMap=pe,L.state=Se,L.info=Ft}v!==gi&&(U=new r1(v,t.width,t.height,a,s,r));let ce=new Af(L,z);this.xr=ce,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let A=Je.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Je.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(A){A!==void 0&&(Me=A,this.setSize(ye,Ae,!1))},this.getSize=function(A){return A.set(ye,Ae)},this.setSize=function(A,G,Q=!0){if(ce.isPresenting){Ze("WebGLRenderer: Can't change size while VR device is presenting.");return}ye=A,Ae=G,t.width=Math.floor(A*Me),t.height=Math.floor(G*Me),Q===!0&&(t.style.width=A+"px",t.style.height=G+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,A,G)},this.getDrawingBufferSize=function(A){return A.set(ye*Me,Ae*Me).floor()},this.setDrawingBufferSize=function(A,G,Q){ye=A,Ae=G,Me=Q,t.width=Math.floor(A*Q),t.height=Math.floor(G*Q),this.setViewport(0,0,A,G)},this.setEffects=function(A){if(v===gi){tt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let G=0;G<A.length;G++)if(A[G].isOutputPass===!0){Ze("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(te)},this.getViewport=function(A){return A.copy(Ge)},this.setViewport=function(A,G,Q,J){A.isVector4?Ge.set(A.x,A.y,A.z,A.w):Ge.set(A,G,Q,J),Se.viewport(te.copy(Ge).multiplyScalar(hn()).round())},this.getScissor=function(A){return A.copy(ut)},this.setScissor=function(A,G,Q,J){A.isVector4?ut.set(A.x,A.y,A.z,A.w):ut.set(A,G,Q,J),Se.scissor(de.copy(ut).multiplyScalar(hn()).round())},this.getScissorTest=function(){return lt},this.setScissorTest=function(A){Se.setScissorTest(lt=A)},this.setOpaqueSort=function(A){Xe=A},this.setTransparentSort=function(A){rt=A},this.getClearColor=function(A){return A.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(A=!0,G=!0,Q=!0){let J=0;if(A){let Z=!1;if(re!==null){let Ee=re.texture.format;Z=m.has(Ee)}if(Z){let Ee=re.texture.type,Pe=p.has(Ee),Te=B.getClearColor(),Ie=B.getClearAlpha(),ze=Te.r,et=Te.g,dt=Te.b;Pe?(x[0]=ze,x[1]=et,x[2]=dt,x[3]=Ie,z.clearBufferuiv(z.COLOR,0,x)):(M[0]=ze,M[1]=et,M[2]=dt,M[3]=Ie,z.clearBufferiv(z.COLOR,0,M))}else J|=z.COLOR_BUFFER_BIT}G&&(J|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(J|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&z.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),O=A},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),B.dispose(),xe.dispose(),ne.dispose(),$e.dispose(),Ve.dispose(),I.dispose(),he.dispose(),$.dispose(),be.dispose(),He.dispose(),ae.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Ka),ce.removeEventListener("sessionend",Hi),hs.stop()};function ke(A){A.preventDefault(),df("WebGLRenderer: Context Lost."),R=!0}function Qe(){df("WebGLRenderer: Context Restored."),R=!1;let A=Ft.autoReset,G=pe.enabled,Q=pe.autoUpdate,J=pe.needsUpdate,Z=pe.type;je(),Ft.autoReset=A,pe.enabled=G,pe.autoUpdate=Q,pe.needsUpdate=J,pe.type=Z}function Ce(A){tt("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function at(A){let G=A.target;G.removeEventListener("dispose",at),Vt(G)}function Vt(A){Hn(A),Ve.remove(A)}function Hn(A){let G=Ve.get(A).programs;G!==void 0&&(G.forEach(function(Q){ae.releaseProgram(Q)}),A.isShaderMaterial&&ae.releaseShaderCache(A))}this.renderBufferDirect=function(A,G,Q,J,Z,Ee){G===null&&(G=vn);let Pe=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Te=Ko(A,G,Q,J,Z);Se.setMaterial(J,Pe);let Ie=Q.index,ze=1;if(J.wireframe===!0){if(Ie=$.getWireframeAttribute(Q),Ie===void 0)return;ze=2}let et=Q.drawRange,dt=Q.attributes.position,Be=et.start*ze,ft=(et.start+et.count)*ze;Ee!==null&&(Be=Math.max(Be,Ee.start*ze),ft=Math.min(ft,(Ee.start+Ee.count)*ze)),Ie!==null?(Be=Math.max(Be,0),ft=Math.min(ft,Ie.count)):dt!=null&&(Be=Math.max(Be,0),ft=Math.min(ft,dt.count));let Zt=ft-Be;if(Zt<0||Zt===1/0)return;be.setup(Z,J,Te,Q,Ie);let Pt,It=ie;if(Ie!==null&&(Pt=w.get(Ie),It=we,It.setIndex(Pt)),Z.isMesh)J.wireframe===!0?(Se.setLineWidth(J.wireframeLinewidth*hn()),It.setMode(z.LINES)):It.setMode(z.TRIANGLES);else if(Z.isLine){let yn=J.linewidth;yn===void 0&&(yn=1),Se.setLineWidth(yn*hn()),Z.isLineSegments?It.setMode(z.LINES):Z.isLineLoop?It.setMode(z.LINE_LOOP):It.setMode(z.LINE_STRIP)}else Z.isPoints?It.setMode(z.POINTS):Z.isSprite&&It.setMode(z.TRIANGLES);if(Z.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))It.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let yn=Z._multiDrawStarts,Ue=Z._multiDrawCounts,un=Z._multiDrawCount,mt=Ie?w.get(Ie).bytesPerElement:1,ds=Ve.get(J).currentProgram.getUniforms();for(let dn=0;dn<un;dn++)ds.setValue(z,"_gl_DrawID",dn),It.render(yn[dn]/mt,Ue[dn])}else if(Z.isInstancedMesh)It.renderInstances(Be,Zt,Z.count);else if(Q.isInstancedBufferGeometry){let yn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ue=Math.min(Q.instanceCount,yn);It.renderInstances(Be,Zt,Ue)}else It.render(Be,Zt)};function Yo(A,G,Q,J){O!==null&&A.isNodeMaterial&&O.setObject(J,A),Bt===!0&&se.setState(A,Q,!1),A.transparent===!0&&A.side===os&&A.forceSinglePass===!1?(A.side=jn,A.needsUpdate=!0,Wi(A,G,J),A.side=nr,A.needsUpdate=!0,Wi(A,G,J),A.side=os):Wi(A,G,J)}this.compile=function(A,G,Q=null){Q===null&&(Q=A),O!==null&&O.renderStart(A,G,Q),E=ne.get(Q),E.init(G),S.push(E),Q.traverseVisible(function(Z){Z.isLight&&Z.layers.test(G.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),A!==Q&&A.traverseVisible(function(Z){Z.isLight&&Z.layers.test(G.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),E.setupLights(),O!==null&&O.updateLights(E.state.lightsArray),cn=this.localClippingEnabled,Bt=se.init(this.clippingPlanes,cn),Bt===!0&&se.setGlobalState(this.clippingPlanes,G),O!==null&&pe.render(E.state.shadowsArray,Q,G);let J=new Set;return A.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Ee=Z.material;if(Ee)if(Array.isArray(Ee))for(let Pe=0;Pe<Ee.length;Pe++){let Te=Ee[Pe];Yo(Te,Q,G,Z),J.add(Te)}else Yo(Ee,Q,G,Z),J.add(Ee)}),E=S.pop(),O!==null&&O.renderEnd(),J},this.compileAsync=function(A,G,Q=null){let J=this.compile(A,G,Q);return new Promise(Z=>{function Ee(){if(J.forEach(function(Pe){let Ie=Ve.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&J.delete(Pe)}),J.size===0){Z(A);return}setTimeout(Ee,10)}Je.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let Rr=null;function eu(A){Rr&&Rr(A)}function Ka(){hs.stop()}function Hi(){hs.start()}let hs=new Sv;hs.setAnimationLoop(eu),typeof self<"u"&&hs.setContext(self),this.setAnimationLoop=function(A){Rr=A,ce.setAnimationLoop(A),A===null?hs.stop():hs.start()},ce.addEventListener("sessionstart",Ka),ce.addEventListener("sessionend",Hi),this.render=function(A,G){if(G!==void 0&&G.isCamera!==!0){tt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(R===!0)return;O!==null&&O.renderStart(A,G);let Q=ce.enabled===!0&&ce.isPresenting===!0,J=U!==null&&(re===null||Q)&&U.begin(L,re);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(G),G=ce.getCamera()),A.isScene===!0&&A.onBeforeRender(L,A,G,re),E=ne.get(A,S.length),E.init(G),E.state.textureUnits=$e.getTextureUnits(),S.push(E),Nt.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?$t.setFromArrayCamera(G):it.setFromProjectionMatrix(Nt,wi,G.reversedDepth),cn=this.localClippingEnabled,Bt=se.init(this.clippingPlanes,cn),C=xe.get(A,y.length),C.init(),y.push(C),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=L.xr.getDepthSensingMesh();Pe!==null&&us(Pe,G,-1/0,L.sortObjects)}us(A,G,0,L.sortObjects),C.finish(),O!==null&&O.updateLights(E.state.lightsArray),L.sortObjects===!0&&C.sort(Xe,rt),Qt=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,Qt&&B.addToRenderList(C,A),this.info.autoReset===!0&&this.info.reset(),Bt===!0&&se.beginShadows();let Z=E.state.shadowsArray;if(pe.render(Z,A,G),Bt===!0&&se.endShadows(),(J&&U.hasRenderPass())===!1){let Pe=C.opaque,Te=C.transmissive;if(E.setupLights(),G.isArrayCamera){let Ie=G.cameras;if(Te.length>0)for(let ze=0,et=Ie.length;ze<et;ze++){let dt=Ie[ze];Ti(Pe,Te,A,dt)}Qt&&B.render(A);for(let ze=0,et=Ie.length;ze<et;ze++){let dt=Ie[ze];Jo(C,A,dt,dt.viewport)}}else Te.length>0&&Ti(Pe,Te,A,G),Qt&&B.render(A),Jo(C,A,G)}re!==null&&k===0&&($e.updateMultisampleRenderTarget(re),$e.updateRenderTargetMipmap(re)),J&&U.end(L),A.isScene===!0&&A.onAfterRender(L,A,G),be.resetDefaultState(),q=-1,j=null,S.pop(),S.length>0?(E=S[S.length-1],$e.setTextureUnits(E.state.textureUnits),Bt===!0&&se.setGlobalState(L.clippingPlanes,E.state.camera)):E=null,y.pop(),y.length>0?C=y[y.length-1]:C=null,O!==null&&O.renderEnd()};function us(A,G,Q,J){if(A.visible===!1)return;if(A.layers.test(G.layers)){if(A.isGroup)Q=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(G);else if(A.isLight)E.pushLight(A),A.castShadow&&E.pushShadow(A);else if(A.isSprite){let Pe=G.isArrayCamera?$t:it;if(!A.frustumCulled||A.intersectsFrustum(Pe)){J&&bt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Nt);let Te=he.update(A),Ie=A.material;Ie.visible&&C.push(A,Te,Ie,Q,bt.z,null,G)}}else if(A.isMesh||A.isLine||A.isPoints){let Pe=G.isArrayCamera?$t:it;if(!A.frustumCulled||A.intersectsFrustum(Pe)){let Te=he.update(A),Ie=A.material;if(J&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),bt.copy(A.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),bt.copy(Te.boundingSphere.center)),bt.applyMatrix4(A.matrixWorld).applyMatrix4(Nt)),Array.isArray(Ie)){let ze=Te.groups;for(let et=0,dt=ze.length;et<dt;et++){let Be=ze[et],ft=Ie[Be.materialIndex];ft&&ft.visible&&C.push(A,Te,ft,Q,bt.z,Be,G)}}else Ie.visible&&C.push(A,Te,Ie,Q,bt.z,null,G)}}}let Ee=A.children;for(let Pe=0,Te=Ee.length;Pe<Te;Pe++)us(Ee[Pe],G,Q,J)}function Jo(A,G,Q,J){let{opaque:Z,transmissive:Ee,transparent:Pe}=A;E.setupLightsView(Q),Bt===!0&&se.setGlobalState(L.clippingPlanes,Q),J&&Se.viewport(te.copy(J)),Z.length>0&&en(Z,G,Q),Ee.length>0&&en(Ee,G,Q),Pe.length>0&&en(Pe,G,Q),Se.buffers.depth.setTest(!0),Se.buffers.depth.setMask(!0),Se.buffers.color.setMask(!0),Se.setPolygonOffset(!1)}function Ti(A,G,Q,J){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[J.id]===void 0){let Be=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[J.id]=new Kn(1,1,{generateMipmaps:!0,type:Be?zi:gi,minFilter:Oi,samples:Math.max(4,ot.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:vt.workingColorSpace})}let Ee=E.state.transmissionRenderTarget[J.id],Pe=J.viewport||te;Ee.setSize(Pe.z*L.transmissionResolutionScale,Pe.w*L.transmissionResolutionScale);let Te=L.getRenderTarget(),Ie=L.getActiveCubeFace(),ze=L.getActiveMipmapLevel();L.setRenderTarget(Ee),L.getClearColor(ee),me=L.getClearAlpha(),me<1&&L.setClearColor(16777215,.5),L.clear(),Qt&&B.render(Q);let et=L.toneMapping;L.toneMapping=as;let dt=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),E.setupLightsView(J),Bt===!0&&se.setGlobalState(L.clippingPlanes,J),en(A,Q,J),$e.updateMultisampleRenderTarget(Ee),$e.updateRenderTargetMipmap(Ee),Je.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let ft=0,Zt=G.length;ft<Zt;ft++){let Pt=G[ft],{object:It,geometry:yn,material:Ue,group:un}=Pt;if(Ue.side===os&&It.layers.test(J.layers)){let mt=Ue.side;Ue.side=jn,Ue.needsUpdate=!0,rn(It,Q,J,yn,Ue,un),Ue.side=mt,Ue.needsUpdate=!0,Be=!0}}Be===!0&&($e.updateMultisampleRenderTarget(Ee),$e.updateRenderTargetMipmap(Ee))}L.setRenderTarget(Te,Ie,ze),L.setClearColor(ee,me),dt!==void 0&&(J.viewport=dt),L.toneMapping=et}function en(A,G,Q){let J=G.isScene===!0?G.overrideMaterial:null;for(let Z=0,Ee=A.length;Z<Ee;Z++){let Pe=A[Z],{object:Te,geometry:Ie,group:ze}=Pe,et=Pe.material;et.allowOverride===!0&&J!==null&&(et=J),Te.layers.test(Q.layers)&&rn(Te,G,Q,Ie,et,ze)}}function rn(A,G,Q,J,Z,Ee){O!==null&&Z.isNodeMaterial&&O.setObject(A,Z),A.onBeforeRender(L,G,Q,J,Z,Ee),A.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),Z.onBeforeRender(L,G,Q,J,A,Ee),Z.transparent===!0&&Z.side===os&&Z.forceSinglePass===!1?(Z.side=jn,Z.needsUpdate=!0,L.renderBufferDirect(Q,G,J,Z,A,Ee),Z.side=nr,Z.needsUpdate=!0,L.renderBufferDirect(Q,G,J,Z,A,Ee),Z.side=os):L.renderBufferDirect(Q,G,J,Z,A,Ee),A.onAfterRender(L,G,Q,J,Z,Ee)}function on(A){let G=0;for(let Q of A)Q.texture!==null&&G++;return G}function Wi(A,G,Q){G.isScene!==!0&&(G=vn);let J=Ve.get(A),Z=E.state.lights,Ee=E.state.shadowsArray,Pe=Z.state.version,Te=ae.getParameters(A,Z.state,Ee,G,Q,E.state.lightProbeGridArray),Ie=ae.getProgramCacheKey(Te),ze=J.programs;J.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?G.environment:null,J.fog=G.fog;let et=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;J.envMap=I.get(A.envMap||J.environment,et),J.envMapRotation=J.environment!==null&&A.envMap===null?G.environmentRotation:A.envMapRotation,ze===void 0&&(A.addEventListener("dispose",at),ze=new Map,J.programs=ze,J.programVariants=new Map);let dt=ze.get(Ie);if(dt!==void 0){if(J.currentProgram===dt&&J.lightsStateVersion===Pe)return Zo(A,Te),dt}else Te.uniforms=ae.getUniforms(A),O!==null&&A.isNodeMaterial&&O.build(A,Q,Te),A.onBeforeCompile(Te,L),dt=ae.acquireProgram(Te,Ie),ze.set(Ie,dt),J.uniforms=Te.uniforms;let Be=J.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Be.clippingPlanes=se.uniform),Zo(A,Te),J.needsLights=Ps(A),J.lightsStateVersion=Pe,J.needsLights&&(Be.ambientLightColor.value=Z.state.ambient,Be.lightProbe.value=Z.state.probe,Be.sunLights.value=Z.state.sun,Be.sunLightShadows.value=Z.state.sunShadow,Be.directionalLights.value=Z.state.directional,Be.directionalLightShadows.value=Z.state.directionalShadow,Be.spotLights.value=Z.state.spot,Be.spotLightShadows.value=Z.state.spotShadow,Be.rectAreaLights.value=Z.state.rectArea,Be.ltc_1.value=Z.state.rectAreaLTC1,Be.ltc_2.value=Z.state.rectAreaLTC2,Be.pointLights.value=Z.state.point,Be.pointLightShadows.value=Z.state.pointShadow,Be.hemisphereLights.value=Z.state.hemi,Be.sunShadowMatrix.value=Z.state.sunShadowMatrix,Be.sunShadowCascade.value=Z.state.sunShadowCascade,Be.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Be.spotLightMatrix.value=Z.state.spotLightMatrix,Be.spotLightMap.value=Z.state.spotLightMap,Be.pointShadowMatrix.value=Z.state.pointShadowMatrix),J.numLightProbeGrids=on(E.state.lightProbeGridArray),J.currentProgram=dt,J.uniformsList=null,dt}function ni(A,G,Q,J,Z){let Ee=Ve.get(A),Pe=Ee.currentProgram.id+","+J+","+Z,Te=Ee.programVariants.get(Pe);return Te===void 0?(Te=Wi(A,G,Q),Ee.programVariants.set(Pe,Te)):(Ee.currentProgram=Te,Ee.uniformsList=null,Ee.outputColorSpace=J,Ee.toneMapping=Z),Te}function Rs(A){if(A.uniformsList===null){let G=A.currentProgram.getUniforms();A.uniformsList=Oo.seqWithValue(G.seq,A.uniforms)}return A.uniformsList}function Zo(A,G){let Q=Ve.get(A);Q.outputColorSpace=G.outputColorSpace,Q.batching=G.batching,Q.batchingColor=G.batchingColor,Q.instancing=G.instancing,Q.instancingColor=G.instancingColor,Q.instancingMorph=G.instancingMorph,Q.skinning=G.skinning,Q.morphTargets=G.morphTargets,Q.morphNormals=G.morphNormals,Q.morphColors=G.morphColors,Q.morphTargetsCount=G.morphTargetsCount,Q.numClippingPlanes=G.numClippingPlanes,Q.numIntersection=G.numClipIntersection,Q.vertexAlphas=G.vertexAlphas,Q.vertexTangents=G.vertexTangents,Q.toneMapping=G.toneMapping}function Ko(A,G,Q,J,Z){G.isScene!==!0&&(G=vn),$e.resetTextureUnits();let Ee=G.fog,Pe=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?G.environment:null,Te=re===null?L.outputColorSpace:re.isXRRenderTarget===!0?re.texture.colorSpace:vt.workingColorSpace,Ie=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,ze=I.get(J.envMap||Pe,Ie),et=J.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,dt=!!Q.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Be=!!Q.morphAttributes.position,ft=!!Q.morphAttributes.normal,Zt=!!Q.morphAttributes.color,Pt=as;J.toneMapped&&(re===null||re.isXRRenderTarget===!0)&&(Pt=L.toneMapping);let It=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,yn=It!==void 0?It.length:0,Ue=Ve.get(J),un=E.state.lights;if(Bt===!0&&(cn===!0||A!==j)){let Lt=A===j&&J.id===q;se.setState(J,A,Lt)}let mt=!1,ds=!1;J.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==un.state.version||Z.isBatchedMesh&&Ue.batching===!1||!Z.isBatchedMesh&&Ue.batching===!0||Z.isBatchedMesh&&Ue.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ue.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ue.instancing===!1||!Z.isInstancedMesh&&Ue.instancing===!0||Z.isSkinnedMesh&&Ue.skinning===!1||!Z.isSkinnedMesh&&Ue.skinning===!0||Z.isInstancedMesh&&Ue.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ue.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ue.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ue.instancingMorph===!1&&Z.morphTexture!==null||Ue.envMap!==ze||J.fog===!0&&Ue.fog!==Ee||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==se.numPlanes||Ue.numIntersection!==se.numIntersection)||Ue.vertexAlphas!==et||Ue.vertexTangents!==dt||Ue.morphTargets!==Be||Ue.morphNormals!==ft||Ue.morphColors!==Zt||Ue.morphTargetsCount!==yn||Ue.numLightProbeGrids!==on(E.state.lightProbeGridArray)?mt=!0:(Ue.outputColorSpace!==Te||Ue.toneMapping!==Pt)&&(ds=!0):(mt=!0,Ue.__version=J.version);let dn=Ue.currentProgram;(mt===!0||ds===!0)&&(dn=ds===!0?ni(J,G,Z,Te,Pt):Wi(J,G,Z),O&&J.isNodeMaterial&&O.onUpdateProgram(J,dn,Ue));let Lr=!1,Xi=!1,fs=!1,ct=dn.getUniforms(),tn=Ue.uniforms;if(Se.useProgram(dn.program)&&(Lr=!0,Xi=!0,fs=!0),J.id!==q&&(q=J.id,Xi=!0),Lr||j!==A){Se.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),ct.setValue(z,"projectionMatrix",A.projectionMatrix),ct.setValue(z,"viewMatrix",A.matrixWorldInverse);let fn=ct.map.cameraPosition;fn!==void 0&&fn.setValue(z,Sn.setFromMatrixPosition(A.matrixWorld)),ot.logarithmicDepthBuffer&&ct.setValue(z,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&ct.setValue(z,"isOrthographic",A.isOrthographicCamera===!0),j!==A&&(j=A,Xi=!0,fs=!0)}if(Ue.needsLights&&(un.state.sunShadowMap.length>0&&ct.setValue(z,"sunShadowMap",un.state.sunShadowMap,$e),un.state.directionalShadowMap.length>0&&ct.setValue(z,"directionalShadowMap",un.state.directionalShadowMap,$e),un.state.spotShadowMap.length>0&&ct.setValue(z,"spotShadowMap",un.state.spotShadowMap,$e),un.state.pointShadowMap.length>0&&ct.setValue(z,"pointShadowMap",un.state.pointShadowMap,$e)),Z.isSkinnedMesh){ct.setOptional(z,Z,"bindMatrix"),ct.setOptional(z,Z,"bindMatrixInverse");let Lt=Z.skeleton;Lt&&(Lt.boneTexture===null&&Lt.computeBoneTexture(),ct.setValue(z,"boneTexture",Lt.boneTexture,$e))}Z.isBatchedMesh&&(ct.setOptional(z,Z,"batchingTexture"),ct.setValue(z,"batchingTexture",Z._matricesTexture,$e),ct.setOptional(z,Z,"batchingIdTexture"),ct.setValue(z,"batchingIdTexture",Z._indirectTexture,$e),ct.setOptional(z,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ct.setValue(z,"batchingColorTexture",Z._colorsTexture,$e));let Wn=Q.morphAttributes;if((Wn.position!==void 0||Wn.normal!==void 0||Wn.color!==void 0)&&oe.update(Z,Q,dn),(Xi||Ue.receiveShadow!==Z.receiveShadow)&&(Ue.receiveShadow=Z.receiveShadow,ct.setValue(z,"receiveShadow",Z.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&G.environment!==null&&(tn.envMapIntensity.value=G.environmentIntensity),tn.dfgLUT!==void 0&&(tn.dfgLUT.value=VE()),Xi){if(ct.setValue(z,"toneMappingExposure",L.toneMappingExposure),Ue.needsLights&&Pr(tn,fs),Ee&&J.fog===!0&&ve.refreshFogUniforms(tn,Ee),ve.refreshMaterialUniforms(tn,J,Me,Ae,E.state.transmissionRenderTarget[A.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Lt=b,fn=0;for(let On of E.state.lightProbeGridArray)On.texture!==null&&(Lt.textures[fn]=On.texture,Lt.min[fn]=On.boundingBox.min,Lt.max[fn]=On.boundingBox.max,Lt.resolution[fn]=On.resolution,fn++);for(let On in Lt)Lt[On].length=fn;tn.probesSH.value=Lt.textures,tn.probesMin.value=Lt.min,tn.probesMax.value=Lt.max,tn.probesResolution.value=Lt.resolution}Oo.upload(z,Rs(Ue),tn,$e)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(Oo.upload(z,Rs(Ue),tn,$e),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&ct.setValue(z,"center",Z.center),ct.setValue(z,"modelViewMatrix",Z.modelViewMatrix),ct.setValue(z,"normalMatrix",Z.normalMatrix),ct.setValue(z,"modelMatrix",Z.matrixWorld),J.uniformsGroups!==void 0){let Lt=J.uniformsGroups;for(let fn=0,On=Lt.length;fn<On;fn++){let ja=Lt[fn];He.update(ja,dn),He.bind(ja,dn)}}return dn}function Pr(A,G){A.ambientLightColor.needsUpdate=G,A.lightProbe.needsUpdate=G,A.sunLights.needsUpdate=G,A.sunLightShadows.needsUpdate=G,A.directionalLights.needsUpdate=G,A.directionalLightShadows.needsUpdate=G,A.pointLights.needsUpdate=G,A.pointLightShadows.needsUpdate=G,A.spotLights.needsUpdate=G,A.spotLightShadows.needsUpdate=G,A.rectAreaLights.needsUpdate=G,A.hemisphereLights.needsUpdate=G}function Ps(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return k},this.getRenderTarget=function(){return re},this.setRenderTargetTextures=function(A,G,Q){let J=Ve.get(A);J.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),Ve.get(A.texture).__webglTexture=G,Ve.get(A.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:Q,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,G){let Q=Ve.get(A);Q.__webglFramebuffer=G,Q.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(A,G=0,Q=0){re=A,Y=G,k=Q;let J=null,Z=!1,Ee=!1;if(A){let Te=Ve.get(A);if(Te.__useDefaultFramebuffer!==void 0){Se.bindFramebuffer(z.FRAMEBUFFER,Te.__webglFramebuffer),te.copy(A.viewport),de.copy(A.scissor),ue=A.scissorTest,Se.viewport(te),Se.scissor(de),Se.setScissorTest(ue),q=-1;return}else if(Te.__webglFramebuffer===void 0)$e.setupRenderTarget(A);else if(Te.__hasExternalTextures)$e.rebindTextures(A,Ve.get(A.texture).__webglTexture,Ve.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let et=A.depthTexture;if(Te.__boundDepthTexture!==et){if(et!==null&&Ve.has(et)&&(A.width!==et.image.width||A.height!==et.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(A)}}let Ie=A.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Ee=!0);let ze=Ve.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(ze[G])?J=ze[G][Q]:J=ze[G],Z=!0):A.samples>0&&$e.useMultisampledRTT(A)===!1?J=Ve.get(A).__webglMultisampledFramebuffer:Array.isArray(ze)?J=ze[Q]:J=ze,te.copy(A.viewport),de.copy(A.scissor),ue=A.scissorTest}else te.copy(Ge).multiplyScalar(Me).floor(),de.copy(ut).multiplyScalar(Me).floor(),ue=lt;if(Q!==0&&(J=V),Se.bindFramebuffer(z.FRAMEBUFFER,J)&&Se.drawBuffers(A,J),Se.viewport(te),Se.scissor(de),Se.setScissorTest(ue),Z){let Te=Ve.get(A.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+G,Te.__webglTexture,Q)}else if(Ee){let Te=G;for(let Ie=0;Ie<A.textures.length;Ie++){let ze=Ve.get(A.textures[Ie]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+Ie,ze.__webglTexture,Q,Te)}}else if(A!==null&&Q!==0){let Te=Ve.get(A.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Te.__webglTexture,Q)}q=-1};function Ir(A){let G=Ve.get(A);return(G.__readFormat!==A.format||G.__readType!==A.type)&&(G.__readFormat=A.format,G.__readType=A.type,G.__formatReadable=ot.textureFormatReadable(A.format),G.__typeReadable=ot.textureTypeReadable(A.type)),G}this.readRenderTargetPixels=function(A,G,Q,J,Z,Ee,Pe,Te=0){if(!(A&&A.isWebGLRenderTarget)){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=Ve.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){Se.bindFramebuffer(z.FRAMEBUFFER,Ie);try{let ze=A.textures[Te],et=ze.format,dt=ze.type;A.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Te);let Be=Ir(ze);if(Be.__formatReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=A.width-J&&Q>=0&&Q<=A.height-Z&&z.readPixels(G,Q,J,Z,ge.convert(et),ge.convert(dt),Ee)}finally{let ze=re!==null?Ve.get(re).__webglFramebuffer:null;Se.bindFramebuffer(z.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(A,G,Q,J,Z,Ee,Pe,Te=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=Ve.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(G>=0&&G<=A.width-J&&Q>=0&&Q<=A.height-Z){Se.bindFramebuffer(z.FRAMEBUFFER,Ie);let ze=A.textures[Te],et=ze.format,dt=ze.type;A.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Te);let Be=Ir(ze);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ft=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,ft),z.bufferData(z.PIXEL_PACK_BUFFER,Ee.byteLength,z.STREAM_READ),z.readPixels(G,Q,J,Z,ge.convert(et),ge.convert(dt),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let Zt=re!==null?Ve.get(re).__webglFramebuffer:null;Se.bindFramebuffer(z.FRAMEBUFFER,Zt);let Pt=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await J0(z,Pt,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,ft),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Ee),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(ft),z.deleteSync(Pt),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,G=null,Q=0){let J=Math.pow(2,-Q),Z=Math.floor(A.image.width*J),Ee=Math.floor(A.image.height*J),Pe=G!==null?G.x:0,Te=G!==null?G.y:0;$e.setTexture2D(A,0),z.copyTexSubImage2D(z.TEXTURE_2D,Q,0,0,Pe,Te,Z,Ee),Se.unbindTexture()},this.copyTextureToTexture=function(A,G,Q=null,J=null,Z=0,Ee=0){let Pe,Te,Ie,ze,et,dt,Be,ft,Zt,Pt=A.isCompressedTexture?A.mipmaps[Ee]:A.image;if(Q!==null)Pe=Q.max.x-Q.min.x,Te=Q.max.y-Q.min.y,Ie=Q.isBox3?Q.max.z-Q.min.z:1,ze=Q.min.x,et=Q.min.y,dt=Q.isBox3?Q.min.z:0;else{let ct=Math.pow(2,-Z);Pe=Math.floor(Pt.width*ct),Te=Math.floor(Pt.height*ct),A.isDataArrayTexture?Ie=Pt.depth:A.isData3DTexture?Ie=Math.floor(Pt.depth*ct):Ie=1,ze=0,et=0,dt=0}J!==null?(Be=J.x,ft=J.y,Zt=J.z):(Be=0,ft=0,Zt=0);let It=ge.convert(G.format),yn=ge.convert(G.type),Ue;G.isData3DTexture?($e.setTexture3D(G,0),Ue=z.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?($e.setTexture2DArray(G,0),Ue=z.TEXTURE_2D_ARRAY):($e.setTexture2D(G,0),Ue=z.TEXTURE_2D),Se.activeTexture(z.TEXTURE0),Se.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,G.flipY),Se.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),Se.pixelStorei(z.UNPACK_ALIGNMENT,G.unpackAlignment);let un=Se.getParameter(z.UNPACK_ROW_LENGTH),mt=Se.getParameter(z.UNPACK_IMAGE_HEIGHT),ds=Se.getParameter(z.UNPACK_SKIP_PIXELS),dn=Se.getParameter(z.UNPACK_SKIP_ROWS),Lr=Se.getParameter(z.UNPACK_SKIP_IMAGES);Se.pixelStorei(z.UNPACK_ROW_LENGTH,Pt.width),Se.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Pt.height),Se.pixelStorei(z.UNPACK_SKIP_PIXELS,ze),Se.pixelStorei(z.UNPACK_SKIP_ROWS,et),Se.pixelStorei(z.UNPACK_SKIP_IMAGES,dt);let Xi=A.isDataArrayTexture||A.isData3DTexture,fs=G.isDataArrayTexture||G.isData3DTexture;if(A.isDepthTexture){let ct=Ve.get(A),tn=Ve.get(G),Wn=Ve.get(ct.__renderTarget),Lt=Ve.get(tn.__renderTarget);Se.bindFramebuffer(z.READ_FRAMEBUFFER,Wn.__webglFramebuffer),Se.bindFramebuffer(z.DRAW_FRAMEBUFFER,Lt.__webglFramebuffer);for(let fn=0;fn<Ie;fn++)Xi&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Ve.get(A).__webglTexture,Z,dt+fn),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Ve.get(G).__webglTexture,Ee,Zt+fn)),z.blitFramebuffer(ze,et,ze+Pe,et+Te,Be,ft,Be+Pe,ft+Te,z.DEPTH_BUFFER_BIT,z.NEAREST);Se.bindFramebuffer(z.READ_FRAMEBUFFER,null),Se.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(Z!==0||A.isRenderTargetTexture||Ve.has(A)){let ct=Ve.get(A),tn=Ve.get(G);Se.bindFramebuffer(z.READ_FRAMEBUFFER,P),Se.bindFramebuffer(z.DRAW_FRAMEBUFFER,H);for(let Wn=0;Wn<Ie;Wn++)Xi?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,ct.__webglTexture,Z,dt+Wn):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,ct.__webglTexture,Z),fs?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,tn.__webglTexture,Ee,Zt+Wn):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,tn.__webglTexture,Ee),Z!==0?z.blitFramebuffer(ze,et,ze+Pe,et+Te,Be,ft,Be+Pe,ft+Te,z.COLOR_BUFFER_BIT,z.NEAREST):fs?z.copyTexSubImage3D(Ue,Ee,Be,ft,Zt+Wn,ze,et,Pe,Te):z.copyTexSubImage2D(Ue,Ee,Be,ft,ze,et,Pe,Te);Se.bindFramebuffer(z.READ_FRAMEBUFFER,null),Se.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else fs?A.isDataTexture||A.isData3DTexture?z.texSubImage3D(Ue,Ee,Be,ft,Zt,Pe,Te,Ie,It,yn,Pt.data):G.isCompressedArrayTexture?z.compressedTexSubImage3D(Ue,Ee,Be,ft,Zt,Pe,Te,Ie,It,Pt.data):z.texSubImage3D(Ue,Ee,Be,ft,Zt,Pe,Te,Ie,It,yn,Pt):A.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Ee,Be,ft,Pe,Te,It,yn,Pt.data):A.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Ee,Be,ft,Pt.width,Pt.height,It,Pt.data):z.texSubImage2D(z.TEXTURE_2D,Ee,Be,ft,Pe,Te,It,yn,Pt);Se.pixelStorei(z.UNPACK_ROW_LENGTH,un),Se.pixelStorei(z.UNPACK_IMAGE_HEIGHT,mt),Se.pixelStorei(z.UNPACK_SKIP_PIXELS,ds),Se.pixelStorei(z.UNPACK_SKIP_ROWS,dn),Se.pixelStorei(z.UNPACK_SKIP_IMAGES,Lr),Ee===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&z.generateMipmap(Ue),Se.unbindTexture()},this.initRenderTarget=function(A){Ve.get(A).__webglFramebuffer===void 0&&$e.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?$e.setTextureCube(A,0):A.isData3DTexture?$e.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?$e.setTexture2DArray(A,0):$e.setTexture2D(A,0),Se.unbindTexture()},this.resetState=function(){Y=0,k=0,re=null,Se.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return wi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=vt._getDrawingBufferColorSpace(e),t.unpackColorSpace=vt._getUnpackColorSpace()}};var Gi=new W,Dv=new W,Uv=new W,Bo=new W,Fv=new zt;function zo(i,e,t,n){let s=new W(2*(t-e.x)/e.width-1,1-2*(n-e.y)/e.height,.5).unproject(i);return new js(i.position.clone(),s.sub(i.position).normalize())}function Nh(i,e,t,n,s,r){let{shape:o,places:a}=i,l=(v,m)=>m.fromArray(a,3*v),c=zo(e,t,n,s),h=1/0,u=-1,d=new W;if(o.triangles){for(let v=0;v<o.triangles.length;v+=3){let[m,p,x]=[o.triangles[v],o.triangles[v+1],o.triangles[v+2]];if(!c.intersectTriangle(l(m,Gi),l(p,Dv),l(x,Uv),!1,Bo))continue;let M=Bo.distanceToSquared(c.origin);if(M>=h)continue;h=M,d.copy(Bo);let[b,C,E]=[Gi.distanceToSquared(Bo),Dv.distanceToSquared(Bo),Uv.distanceToSquared(Bo)];u=b<=C&&b<=E?m:C<=E?p:x}if(u>=0)return{point:o.point[u],place:l(u,new W),surface:d}}Fv.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse);let f=r*r;for(let v=0;v<o.corners;v++){l(v,Gi).applyMatrix4(Fv);let m=t.x+(Gi.x+1)/2*t.width-n,p=t.y+(1-Gi.y)/2*t.height-s,x=m*m+p*p+40*Gi.z;Gi.z<1&&m*m+p*p<r*r&&x-40<f&&(f=x-40,u=v)}if(u<0)return null;let g=l(u,new W);return{point:o.point[u],place:g,surface:g.clone()}}function Dh(i,e,t){return Gi.copy(t).project(i),Gi.z>1?null:{x:e.x+(Gi.x+1)/2*e.width,y:e.y+(1-Gi.y)/2*e.height}}var GE=30,Cf=14,HE=6,WE=.15,Uh=class{constructor(e,t){this.picture=e;this.store=t;let{canvas:n}=e,s=(r,o,a,l=!0)=>{r.addEventListener(o,a,{passive:l}),this.ends.push(()=>r.removeEventListener(o,a))};s(n,"pointerdown",r=>this.down(r)),s(n,"pointermove",r=>this.move(r)),s(n,"pointerrawupdate",r=>this.raw(r)),s(n,"pointerup",r=>this.up(r)),s(n,"pointercancel",r=>this.up(r)),s(n,"pointerleave",()=>this.leave()),s(n,"wheel",r=>this.wheel(r),!1),s(n,"contextmenu",r=>r.preventDefault(),!1),s(n,"dblclick",r=>this.double(r)),s(window,"keydown",r=>this.key(r),!1),s(window,"blur",()=>this.release())}picture;store;pointers=new Map;doing=null;holder=-1;moved=0;over=null;ends=[];pads=new ro;dispose(){this.release();for(let e of this.ends)e()}release(){this.picture.hold.release(),this.doing==="hold"&&(this.doing=null),this.holder=-1,this.picture.draw()}step(e){let{hold:t,orbit:n}=this.picture,s=this.doing==="hold"&&this.moved<HE&&t.push(e,n.axes()[2]);this.over&&this.picture.hover(!t.holds&&this.picture.mayAct()?this.picture.pick(this.over.x,this.over.y,Cf):null);let r=this.pads.read();if(!r)return s;if(r.pressed&&!t.holds&&this.grabCentre(),r.released&&t.holds&&t.release(),t.holds&&Math.hypot(r.x,r.y,r.depth)>WE){let[o,a,l]=n.axes(),c=1.2*n.metres(this.picture.ownCell().height)*this.picture.ownCell().height*.5*e;t.shift(o.multiplyScalar(r.x*c).addScaledVector(a,-r.y*c).addScaledVector(l,r.depth*c)),s=!0}return this.pads.rumble(t.holds?this.picture.force():0),s||t.holds}at(e){let t=this.picture.canvas.getBoundingClientRect();return{x:e.clientX-t.left,y:e.clientY-t.top}}down(e){let{canvas:t,hold:n,orbit:s}=this.picture,r=this.at(e);if(t.setPointerCapture(e.pointerId),this.pointers.set(e.pointerId,r),this.moved=0,e.pointerType==="touch"&&this.pointers.size===2){this.doing==="hold"&&n.release(),this.doing="two";return}if(!(this.pointers.size>1)){if(e.button===1||e.button===0&&e.shiftKey)this.doing="pan";else if(e.button===2||e.ctrlKey)this.doing="turn";else{let o=this.picture.mayAct()?this.picture.pick(r.x,r.y,e.pointerType==="touch"?GE:Cf):null;if(this.doing=o?"hold":"turn",o){this.holder=e.pointerId;let a=s.axes()[2];this.store.settings.tool==="ball"?n.press(o.surface,a,e.timeStamp):n.grab(o.point,o.place,o.surface,a,e.timeStamp),this.picture.hover(null)}}t.dataset.doing=this.doing,this.picture.draw()}}move(e){let t=this.at(e),{orbit:n,hold:s}=this.picture,r=this.pointers.get(e.pointerId);if(!r){e.pointerType!=="touch"&&(this.over=t),this.picture.draw();return}let[o,a]=[t.x-r.x,t.y-r.y];this.moved+=Math.hypot(o,a);let l=this.picture.ownCell().height;if(this.doing==="two"&&this.pointers.size===2){let c=[...this.pointers].find(([u])=>u!==e.pointerId)[1],h=u=>Math.max(Math.hypot(u.x-c.x,u.y-c.y),10);n.zoom(h(r)/h(t)),n.turn(o/2,a/2)}else if(this.doing==="hold"&&e.pointerId===this.holder){let c=zo(n.camera,this.picture.ownCell(),t.x,t.y);s.follow(c,e.timeStamp)}else this.doing==="turn"?n.turn(o,a):this.doing==="pan"&&n.pan(o,a,l);this.pointers.set(e.pointerId,t),this.picture.draw()}raw(e){if(this.doing!=="hold"||e.pointerId!==this.holder)return;let t=this.at(e);this.picture.hold.follow(zo(this.picture.orbit.camera,this.picture.ownCell(),t.x,t.y),e.timeStamp)}up(e){this.pointers.delete(e.pointerId),this.doing==="hold"&&e.pointerId===this.holder&&(this.picture.hold.release(e.timeStamp),this.holder=-1,this.doing=null),this.doing==="two"&&this.pointers.size===1&&(this.doing="turn"),this.pointers.size||(this.doing=null),delete this.picture.canvas.dataset.doing,e.pointerType!=="touch"&&(this.over=this.at(e)),this.picture.draw()}leave(){this.over=null,this.picture.hover(null),this.picture.draw()}wheel(e){e.preventDefault();let{orbit:t,hold:n}=this.picture,{height:s}=this.picture.ownCell(),r=Math.max(-3,Math.min(3,(e.deltaY||e.deltaX)/(e.deltaMode?3:100)));e.shiftKey&&this.store.settings.tool==="ball"?(n.radius=Math.min(Math.max(n.radius*.9**r,.2*.16*t.size),.8*t.size),n.action==="ball"&&n.send()):n.holds?n.depth(-r*.06*t.metres(s)*s*.5,t.axes()[2]):t.zoom(1.12**r),this.picture.draw()}double(e){let t=this.at(e),{seat:n}=this.picture.cellAt(t.x,t.y);n!==this.store.seat&&this.store.scene?.own.includes(n)?this.store.take(n):this.picture.pick(t.x,t.y,Cf)||this.picture.orbit.reset(),this.picture.draw()}grabCentre(){let e=this.picture.ownCell();if(!this.picture.mayAct())return;let t=this.picture.pick(e.x+e.width/2,e.y+e.height/2,Math.max(e.width,e.height));if(!t)return;let n=this.picture.orbit.axes()[2];this.store.settings.tool==="ball"?this.picture.hold.press(t.surface,n):this.picture.hold.grab(t.point,t.place,t.place,n)}key(e){let{hold:t,orbit:n,canvas:s}=this.picture;if(!Rf(e)){if(e.key==="Escape"&&t.holds){this.release(),e.preventDefault();return}if(!(document.activeElement!==s&&document.activeElement!==document.body)){if(e.key==="g"||e.key==="G")t.holds?this.release():this.grabCentre();else if(e.key in Ov){let[r,o]=Ov[e.key];if(t.holds){let[a,l,c]=n.axes(),h=.05*n.size;t.shift(e.shiftKey?c.multiplyScalar(o*h):a.multiplyScalar(r*h).addScaledVector(l,o*h))}else n.turn(-40*r,40*o)}else if(e.key==="+"||e.key==="=")n.zoom(1/1.15);else if(e.key==="-")n.zoom(1.15);else if(e.key==="0"||e.key==="Home")n.reset();else return;e.preventDefault(),this.picture.draw()}}}},Ov={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function Rf(i){let e=i.target;return i.defaultPrevented||i.ctrlKey||i.metaKey||i.altKey?!0:!!e?.closest?.("input, select, textarea, [contenteditable], dialog")}var Fh=class{constructor(e,t){this.rails=e;this.connection=t;let{canvas:n}=e,s=(r,o,a)=>{r.addEventListener(o,a),this.ends.push(()=>r.removeEventListener(o,a))};s(n,"pointerdown",r=>this.down(r)),s(n,"pointermove",r=>this.move(r)),s(n,"pointerrawupdate",r=>{this.holds&&r.pointerId===this.finger&&this.follow(this.at(r).x,r.timeStamp)}),s(n,"pointerup",r=>this.up(r)),s(n,"pointercancel",r=>this.up(r)),s(n,"dblclick",r=>{let o=e.whose(this.at(r).y);o!==null&&e.take(o)}),s(window,"keydown",r=>this.key(r)),s(window,"blur",()=>this.release())}rails;connection;holds=!1;point=0;target=0;offset=0;finger=-1;pads=new ro;ends=[];dispose(){this.release();for(let e of this.ends)e()}release(e){this.holds&&(this.holds=!1,this.finger=-1,this.send(e),this.rails.draw())}send(e){this.connection.point({action:this.holds?"grab":"free",point:this.point,target:[this.target,0,0],radius:0,stiffness:this.rails.stiffness,time:e})}step(e){let t=this.pads.read();return t?(t.pressed&&this.grabMiddle(),t.released&&this.release(),this.holds&&Math.abs(t.x)>.15&&this.shift(t.x*this.rails.span()*.5*e),this.pads.rumble(this.holds?this.rails.force():0),this.holds):!1}at(e){let t=this.rails.canvas.getBoundingClientRect();return{x:e.clientX-t.left,y:e.clientY-t.top}}down(e){let{x:t,y:n}=this.at(e),s=this.rails.mayAct()&&e.button===0&&this.finger<0?this.rails.reach(t,n,e.pointerType==="touch"):null;s&&(this.rails.canvas.setPointerCapture(e.pointerId),this.finger=e.pointerId,this.holds=!0,this.point=s.point,this.offset=s.near?s.place-this.rails.metres(t):0,this.follow(t,e.timeStamp))}move(e){let{x:t,y:n}=this.at(e);this.holds&&e.pointerId===this.finger?this.follow(t,e.timeStamp):this.holds||(this.rails.canvas.dataset.over=this.rails.mayAct()&&this.rails.reach(t,n,!1)?"grab":"rails")}up(e){e.pointerId===this.finger&&this.release(e.timeStamp)}follow(e,t){this.target=this.rails.metres(e)+this.offset,this.send(t),this.rails.draw()}shift(e){let t=this.rails.span();this.target=Math.min(Math.max(this.target+e,this.rails.metres(0)-t),this.rails.metres(0)+2*t),this.send(),this.rails.draw()}grabMiddle(){let e=this.rails.mayAct()&&!this.holds?this.rails.reach(NaN,NaN,!0):null;e&&(this.holds=!0,this.point=e.point,this.target=e.place,this.send(),this.rails.draw())}key(e){if(!Rf(e)){if(e.key==="Escape"&&this.holds)this.release();else{if(document.activeElement!==this.rails.canvas&&document.activeElement!==document.body)return;if(e.key==="g"||e.key==="G")this.holds?this.release():this.grabMiddle();else if(this.holds&&(e.key==="ArrowLeft"||e.key==="ArrowRight"))this.shift((e.key==="ArrowLeft"?-.02:.02)*this.rails.span());else return}e.preventDefault()}}};var kv={light:{text:"#1b2330",soft:"#55606f",rail:"#d3dae4",line:"rgb(27 35 48 / 0.09)",paper:"#ffffff",dark:!1},dark:{text:"#eef1f5",soft:"#a7b0bd",rail:"#3a424f",line:"rgb(255 255 255 / 0.08)",paper:"#171b22",dark:!0}};function Go(i,e,t,n,s){i.font=`${s.weight??400} ${s.size}px system-ui, sans-serif`,i.fillStyle=s.colour,i.textAlign=s.align??"left",i.textBaseline="middle",i.fillText(e,t,n)}function Pf(i,e,t,n,s,r){i.lineCap="round",i.lineWidth=s,i.strokeStyle=r,i.beginPath(),i.moveTo(e,n),i.lineTo(t,n),i.stroke()}function Bv(i,e,t,n,s,r,o){i.save(),i.shadowColor=r.dark?"rgb(0 0 0 / 0.55)":"rgb(20 30 50 / 0.28)",i.shadowBlur=o?14:8,i.shadowOffsetY=o?4:2,i.fillStyle=r.dark?"#f3f5f8":"#ffffff",Vo(i,e,t,n),i.restore();let[a,l,c]=Fs(s),h=i.createLinearGradient(e,t-n,e,t+n);h.addColorStop(0,`rgb(${[a,l,c].map(u=>Math.round(u+(255-u)*.22)).join(" ")})`),h.addColorStop(1,s),i.fillStyle=h,Vo(i,e,t,n-2.5),i.strokeStyle="rgb(255 255 255 / 0.75)",i.lineWidth=1.5,i.lineCap="round",i.beginPath();for(let u of[-.22,0,.22])i.moveTo(e+u*n,t-.3*n),i.lineTo(e+u*n,t+.3*n);i.stroke()}function Vo(i,e,t,n){i.beginPath(),i.arc(e,t,Math.max(n,0),0,2*Math.PI),i.fill()}function zv(i,e,t,n,s,r=2){i.strokeStyle=s,i.lineWidth=r,i.beginPath(),i.arc(e,t,n,0,2*Math.PI),i.stroke()}function If(i,e,t,n,s,r){i.beginPath(),i.moveTo(e,t-n),i.lineTo(e+n,t),i.lineTo(e,t+n),i.lineTo(e-n,t),i.closePath(),i.fillStyle=r.paper,i.fill(),i.fillStyle=Os(s,.35),i.fill(),i.strokeStyle=s,i.lineWidth=1.75,i.lineJoin="round",i.stroke()}function Vv(i,e,t,n,s){if(Math.abs(n)<5)return;let r=Math.sign(n);i.strokeStyle=i.fillStyle=s,i.lineWidth=3,i.lineCap="butt",i.beginPath(),i.moveTo(e,t),i.lineTo(e+n-7*r,t),i.stroke(),i.beginPath(),i.moveTo(e+n,t),i.lineTo(e+n-9*r,t-5),i.lineTo(e+n-9*r,t+5),i.fill()}function Gv(i,e,t,n,s,r){Pf(i,e,t,n,s,r)}function Hv(i,e,t,n,s,r,o,a,l,c){let h=(e+n)/2+2*r,u=(t+s)/2,d=Math.hypot(n-e,s-t)+Math.abs(r);i.strokeStyle=a,i.lineJoin="round",i.lineCap="round",i.lineWidth=1.8+1.6*o,i.setLineDash(l?[2,7]:[]),i.beginPath();let f=Math.max(4,Math.round(d/15)),g=l?24:f*10,v=l||c?0:6.5*(1-.45*o);for(let m=0;m<=g;m++){let p=m/g,x=1-p,M=x*x*e+2*x*p*h+p*p*n,b=x*x*t+2*x*p*u+p*p*s,C=2*x*(h-e)+2*p*(n-h),E=2*x*(u-t)+2*p*(s-u),y=Math.hypot(C,E)||1,S=Math.min(1,Math.max(0,(Math.min(p,x)*d-16)/14)),U=v*S*Math.sin(p*f*2*Math.PI);M+=-E/y*U,b+=C/y*U,m?i.lineTo(M,b):i.moveTo(M,b)}i.stroke(),i.setLineDash([])}var Wv=900,Lf=matchMedia("(prefers-reduced-motion: reduce)");function Xv(i,e,t,n,s){return new Nf(i,e,t,n,s)}var Nf=class{constructor(e,t,n,s,r){this.scene=t;this.store=n;this.connection=s;this.stats=r;this.stiffness=t.stiffness,this.canvas.className="ct-canvas",this.canvas.dataset.over="rails",this.canvas.tabIndex=0,this.canvas.setAttribute("role","application"),this.canvas.setAttribute("aria-label","One slider for every user. Drag yours; G grabs, arrows move, Escape lets go."),e.append(this.canvas),this.furniture=new so(e,n,"Drag your slider and feel the others through it."),this.furniture.legend("plain",""),this.drag=new Fh(this,s);let o=new ResizeObserver(()=>this.resize());o.observe(e);let a=()=>this.draw();this.ends.push(()=>o.disconnect(),zr(a),n.on("settings",a),n.on("frame",a),n.on("state",a),n.on("seat",()=>{this.drag.release(),this.draw()}),n.on("connection",()=>{n.connection==="open"&&this.drag.holds&&this.drag.send()})),this.resize()}scene;store;connection;stats;canvas=document.createElement("canvas");stiffness;pen=this.canvas.getContext("2d");drag;furniture;ends=[];width=0;height=0;shown=null;handle=0;last=0;half=.1;wanted=.1;proxy=0;pulsed={seat:-1,since:-1/0};reset(){this.wanted=.1,this.draw()}pulse(e){this.pulsed={seat:e,since:performance.now()},this.draw()}spot(e=0){let t=this.copy(this.store.seat);return t?{x:this.x(this.place(t,e)),y:this.y(this.store.seat),point:e}:null}aim(e){let t=e-this.canvas.getBoundingClientRect().left,n=this.reach(t,this.y(this.store.seat),!0);return n&&{point:n.point,to:[this.metres(t),0,0]}}dispose(){cancelAnimationFrame(this.handle),this.handle=-1,this.drag.dispose(),this.furniture.dispose();for(let e of this.ends)e();this.canvas.remove()}reach(e,t,n){let s=this.copy(this.store.seat);if(!s)return null;let r=Number.isNaN(e);if(!r&&Math.abs(t-this.y(this.store.seat))>Math.max(this.gap*.45,n?34:24))return null;let o=0,a=1/0;for(let l=0;l<this.shown.points;l++){let c=Math.abs(this.x(this.place(s,l))-(r?this.x(this.scene.centre[0]):e));c<a&&([a,o]=[c,l])}return{point:o,place:this.place(s,o),near:a<44}}metres(e){return this.scene.centre[0]+(e-this.middle)/(this.right-this.left)*2*this.half}span(){return 2*this.half}force(){return Math.min(this.pull()/this.most,1)}mayAct(){return this.connection.mayAct}whose(e){return this.scene.users.find(({seat:t})=>Math.abs(this.y(t)-e)<this.gap/2)?.seat??null}take(e){this.scene.own.includes(e)&&this.store.take(e)}draw(){this.handle||(this.handle=requestAnimationFrame(e=>this.tick(e)))}get narrow(){return this.width<620}get left(){return this.narrow?30:168}get right(){return this.width-(this.narrow?30:104)}get middle(){return(this.left+this.right)/2}get gap(){return(this.height-this.foot-30)/this.scene.users.length}get foot(){return this.narrow?108:66}get most(){return this.scene.stiffness*this.half}y(e){return 26+this.gap*(this.scene.users.findIndex(t=>t.seat===e)+.5)+(this.narrow?8:0)}x(e){return this.middle+(e-this.scene.centre[0])/(2*this.half)*(this.right-this.left)}copy(e){return this.shown?.copies.find(t=>t.seat===e)}place(e,t){return this.scene.points[3*t]+e.displacement[3*t]*this.shown.scale}mean(e){let t=0;for(let n=0;n<this.shown.points;n++)t+=this.place(e,n);return t/Math.max(this.shown.points,1)}pull(){let e=this.copy(this.store.seat);return this.drag.holds&&e?this.stiffness*Math.abs(this.drag.target-this.place(e,this.drag.point)):0}resize(){let e=this.canvas.parentElement?.getBoundingClientRect();if(!e||e.width<1||e.height<1)return;[this.width,this.height]=[Math.round(e.width),Math.round(e.height)];let t=devicePixelRatio||1;this.canvas.width=Math.round(this.width*t),this.canvas.height=Math.round(this.height*t),this.pen.setTransform(t,0,0,t,0,0),this.draw()}tick(e){this.handle=0;let t=Math.min((e-this.last)/1e3,.1);this.last=e;let n=this.store.frame!==null&&this.store.frame!==this.shown;this.shown=this.store.frame;let s=this.drag.step(t);s=this.range(t)||s,s=this.lag(t)||s,s=e-this.pulsed.since<Wv||s,this.paint(e),n&&this.stats.drew(this.shown.echo,this.shown.received,performance.now()),s&&this.draw()}range(e){if(!this.shown||this.drag.holds)return!1;let t=0;for(let n of this.shown.copies){for(let s=0;s<this.shown.points;s++)t=Math.max(t,Math.abs(this.place(n,s)-this.scene.centre[0]));n.hasHand&&n.mode!=="free"&&(t=Math.max(t,Math.abs(n.target[0]-this.scene.centre[0])))}return(t>.92*this.wanted||t<.3*this.wanted)&&(this.wanted=Math.max(io(t*1.15),.1)),this.half+=(this.wanted-this.half)*(Lf.matches?1:1-Math.exp(-e*5)),Math.abs(this.half-this.wanted)>.001*this.wanted?!0:(this.half=this.wanted,!1)}lag(e){let t=this.copy(this.store.seat);if(!this.drag.holds||!t)return this.proxy=NaN,!1;Number.isNaN(this.proxy)&&(this.proxy=this.drag.target);let n=this.force(),s=this.place(t,this.drag.point),r=this.drag.target+(s-this.drag.target)*.6*n/(n+.45);return this.proxy+=(r-this.proxy)*(Lf.matches?1:1-Math.exp(-e*55)),Math.abs(r-this.proxy)>1e-4*this.half}paint(e){let{pen:t,store:n}=this,s=Us(n.settings.theme),r=kv[s?"dark":"light"];t.clearRect(0,0,this.width,this.height),this.scale(r);let o=this.scene.users.map(a=>a.seat);for(let a of o)this.rail(a,r,e);this.springs(r);for(let a of o)this.beliefs(a,r);for(let a of o)this.slider(a,r);this.key(r)}scale(e){let{pen:t}=this,n=this.height-this.foot+4;for(let s=-4;s<=4;s++){let r=Math.round(this.middle+s/8*(this.right-this.left))+.5;if(t.strokeStyle=s===0?Os(e.dark?"#ffffff":"#1b2330",.22):e.line,t.lineWidth=1,t.beginPath(),t.moveTo(r,22),t.lineTo(r,n),t.stroke(),s%2===0&&!(this.narrow&&Math.abs(s)>2)){let o=s===0?"rest":`${s>0?"+":""}${Ll(s/4*this.half,this.half/2)}`;Go(t,o,r,n+13,{size:11.5,colour:e.soft,align:"center"})}}}key(e){let t=this.height-25,n=this.narrow?22:32;If(this.pen,n,t,5.5,e.soft,e),Go(this.pen,"where a user believes its neighbours to be, by what has arrived",n+13,t,{size:12,colour:e.soft})}rail(e,t,n){let{pen:s,store:r}=this,o=xi(e,t.dark),a=this.y(e),l=e===r.seat,c=this.copy(e),h=!c||r.state?.members[e]?.here===!1;l&&(s.fillStyle=Os(o,t.dark?.13:.07),s.beginPath(),s.roundRect(8,a-this.gap*.46,this.width-16,this.gap*.92,14),s.fill());let u=(n-this.pulsed.since)/Wv;e===this.pulsed.seat&&u<1&&(s.strokeStyle=Os(o,Lf.matches?.8:Math.sin(u*Math.PI*3)**2),s.lineWidth=3,s.beginPath(),s.roundRect(8,a-this.gap*.46,this.width-16,this.gap*.92,14),s.stroke()),Pf(s,this.left,this.right,a,l?7:5,t.rail);let d=this.scene.users.find(b=>b.seat===e).name,f=r.state?Il(r.state,r.seat).get(e):void 0,g=c&&!c.direct?`, ${Gs(c.age)} old`:"",v=h?"not here":l?"you":r.state?f===void 0?"out of reach":this.narrow?`+${Gs(f)}`:`feels you ${Gs(f)} later${g}`:"",[m,p]=this.narrow?[this.left-8,a-this.gap*.33]:[26,a-9];Go(s,d,m,p,{size:15,weight:650,colour:h?t.soft:o});let x=this.narrow?[m+s.measureText(d).width+8,p]:[m,a+10];if(Go(s,v,x[0],x[1],{size:12,colour:t.soft}),h)return;let M=l&&this.drag.holds?this.pull():Math.abs(c.force[0]);if(M>.005){let[b,C]=this.narrow?[this.right+8,p]:[this.width-26,a];Go(s,Nl(M),b,C,{size:13,weight:600,colour:t.text,align:"right"})}}springs(e){let{state:t}=this.store;if(!t||!this.shown)return;let n=s=>this.scene.users.findIndex(r=>r.seat===s);for(let[s,r]of t.links){let[o,a]=[this.copy(s),this.copy(r)];if(!o||!a)continue;let[l,c]=[this.mean(o),this.mean(a)],h=!!t.emulated[`${s}-${r}`]?.cut||!!t.emulated[`${r}-${s}`]?.cut,u=t.ends[`${s}-${r}`],d=h||u&&u.state!=="coupled"&&u.state!=="ready"&&u.state!=="guarded",f=Math.min(Math.abs(l-c)/(.6*this.half),1),g=Math.abs(n(s)-n(r)),v=g<2?0:(g-1)*Math.min(this.gap*.42,38)*((n(s)+n(r))%2?1:-1),m=d?Os(e.dark?"#a7b0bd":"#55606f",.55):pa(f,e.dark);Hv(this.pen,this.x(l),this.y(s),this.x(c),this.y(r),v,f,m,!!d,!1)}}beliefs(e,t){let{state:n,history:s}=this.store;if(!(!n||!this.copy(e)))for(let[r,o]of n.links){if(r!==e&&o!==e)continue;let a=r===e?o:r,l=ad(n,e,a);if(l===null||!this.copy(a))continue;let c=s.before(a,l);if(Number.isNaN(c))continue;let h=0;for(let u=0;u<this.shown.points;u++)h+=this.scene.points[3*u]/this.shown.points;If(this.pen,this.x(h+c),this.y(e),6,xi(a,t.dark),t)}}slider(e,t){let n=this.copy(e);if(!n)return;let{pen:s}=this,r=xi(e,t.dark),o=this.y(e),a=e===this.store.seat,l=a&&this.drag.holds,c=Math.min(a?19:15,this.gap*.3),h=l?this.drag.point:Math.max(n.node,0),u=l||n.hasHand&&n.mode!=="free"&&n.node>=0,d=this.x(this.place(n,Math.min(h,this.shown.points-1))),f=l?Math.sign(this.drag.target-this.place(n,h))*this.pull():n.force[0];if(u){let v=Math.min(Math.abs(f)/this.most,1),m=this.x(l?this.drag.target:n.target[0]);Gv(s,d,m,o,3+4*v,pa(v,t.dark)),l?(s.fillStyle=r,Vo(s,this.x(this.proxy),o,7),zv(s,m,o,12,r,2.5)):(s.fillStyle=r,Vo(s,m,o,5))}if(this.shown.points>1)for(let v=0;v<this.shown.points;v++)s.fillStyle=Os(r,.85),Vo(s,this.x(this.place(n,v)),o,Math.min(c*.5,8));let g=this.shown.points>1&&u?d:this.x(this.mean(n));Bv(s,g,o,c,r,t,a),u&&Vv(s,g,o-c-8,f/this.most*(this.right-this.left)*.3,r)}};var qv=[2,1,.75,.55,.4],Oh=class{constructor(e){this.finest=e;this.level=e()>1?0:1}finest;level;drawn=0;missed=0;kept=0;wait=240;get ratio(){return Math.min(this.finest(),qv[this.level])}get shadows(){return this.level>2?3:1}took(e,t){let n=this.ratio;this.drawn++;let s=t>.021?Math.min(e,6):0;return this.missed+=s,this.kept=s?0:this.kept+1,this.drawn>=24&&(this.missed>.06*(this.drawn+this.missed)&&this.level<qv.length-1&&(this.level++,this.kept=0,this.wait=Math.min(2*this.wait,15360)),this.drawn=this.missed=0),this.kept>this.wait&&this.level>0&&this.ratio<this.finest()&&(this.level--,this.kept=this.drawn=this.missed=0),this.ratio!==n}},XE=null;function Ei(){return XE??=qE()}function qE(){let i=document.createElement("canvas").getContext("webgl2"),e=i?.getExtension("WEBGL_debug_renderer_info"),t=i&&e?String(i.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";return i?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software/i.test(t)}function Ho(){return Ei()?{LEAN:""}:{}}var Ja=`
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
`,kh=`
uniform vec3 stops[9];
vec3 ramp(float value) {
  float at = clamp(value, 0.0, 1.0) * 8.0;
  int low = min(int(at), 7);
  return mix(stops[low], stops[low + 1], at - float(low));
}
`,$v={vertex:`
    ${Ja}${kh}
    attribute vec3 shift;
    attribute float value;
    uniform float scale, full, flash;
    uniform vec3 plain;
    uniform int by;
    #ifdef LEAN
    varying vec3 shown;
    #else
    varying vec3 n, p;
    varying float v;
    #endif
    void main() {
      vec4 q = modelViewMatrix * vec4(position + shift * scale, 1.0);
      float far = (by == 0 ? length(shift) * scale : value) / full;
      gl_Position = projectionMatrix * q;
      #ifdef LEAN
      vec3 eye = normalize(-q.xyz), m = normalize(mat3(modelViewMatrix) * normal + 1e-20);
      if (dot(m, eye) < -0.2) m = -m;
      shown = mix(lit(by == 2 ? plain : ramp(far), m, eye, 0.20), vec3(1.0), flash * 0.5);
      #else
      n = mat3(modelViewMatrix) * normal;
      p = q.xyz;
      v = far;
      #endif
    }`,fragment:`
    #ifdef LEAN
    varying vec3 shown;
    void main() { gl_FragColor = vec4(shown, 1.0); }
    #else
    ${Ja}${kh}
    uniform vec3 plain;
    uniform int by;
    uniform float flash;
    varying vec3 n, p;
    varying float v;
    void main() {
      vec3 eye = normalize(-p), m = normalize(n);
      if (!gl_FrontFacing) m = -m;
      vec3 colour = by == 2 ? plain : ramp(v);
      gl_FragColor = vec4(mix(lit(colour, m, eye, 0.20), vec3(1.0), flash * 0.5), 1.0);
    }
    #endif`},Yv={vertex:`
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
    #endif`},Bh={vertex:`
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
    ${Ja}${kh}
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
    }`},Df={vertex:Bh.vertex.replace(/gl_PointSize.*\n/,`
`),fragment:`
    ${kh}
    uniform vec3 plain;
    uniform int by;
    uniform float opacity;
    varying float v;
    void main() { gl_FragColor = vec4((by == 2 ? plain : ramp(v)) * 0.85, opacity); }`},Uf={vertex:`
    ${Ja}
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
    ${Ja}
    uniform vec3 colour;
    varying vec3 n, p;
    void main() { gl_FragColor = vec4(lit(colour, normalize(n), normalize(-p), 0.35), opacity); }
    #endif`},Ff={vertex:`
    attribute vec3 shift;
    uniform float scale, ground, reach;
    varying float height;
    void main() {
      vec4 q = modelMatrix * vec4(position + shift * scale, 1.0);
      height = (q.z - ground) / reach;
      gl_Position = projectionMatrix * viewMatrix * q;
    }`,fragment:`
    varying float height;
    void main() { gl_FragColor = vec4(1.0, clamp(height, 0.0, 1.0), 0.0, 1.0); }`},Of={vertex:`
    varying vec2 at;
    void main() {
      vec4 q = modelMatrix * vec4(position, 1.0);
      at = q.xy;
      gl_Position = projectionMatrix * viewMatrix * q;
    }`,fragment:`
    uniform sampler2D shadow;
    uniform vec2 centre;
    uniform vec3 line, dark;
    uniform float reach, pitch, strength, opacity;
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
      float grid = opacity * fade * max(lines(q), 0.55 * lines(q * 5.0));
      float all = cover + grid * (1.0 - cover);
      gl_FragColor = vec4(mix(line, dark, cover / max(all, 1e-4)), all);
    }`};var $E=Math.cos(50*Math.PI/180),zh=class{constructor(e){this.scene=e;let t=e.points.length/3;if(e.skin){let s=JE(e.points,e.skin.triangles);this.point=s.point,this.triangles=s.triangles}else this.point=Uint32Array.from({length:t},(s,r)=>r),this.triangles=null;this.corners=this.point.length,this.rest=new Float32Array(this.corners*3),this.corner=new Uint32Array(t),this.point.forEach((s,r)=>{this.corner[s]=r;for(let o=0;o<3;o++)this.rest[3*r+o]=e.points[3*s+o]}),this.sides=e.skin?YE(e.skin.triangles,this.corner,t):e.edges??new Uint32Array;let n=this.sides.length/2;this.restLengths=new Float32Array(n),this.degree=new Float32Array(this.corners);for(let s=0;s<n;s++){let r=this.sides[2*s],o=this.sides[2*s+1];this.restLengths[s]=Jv(this.rest,r,o),this.degree[r]++,this.degree[o]++}for(let s=0;s<this.corners;s++)this.degree[s]=Math.max(this.degree[s],1)}scene;point;rest;triangles;sides;corner;restLengths;degree;corners},Vh=class{constructor(e){this.shape=e;let t=e.corners,n=(r,o)=>new Vn(r,o).setUsage(Th);this.places=e.rest.slice(),this.seen=new Uint8Array(t),this.shift=n(new Int16Array(3*t),3),this.normal=n(new Float32Array(3*t),3),this.value=n(new Float32Array(t),1);let s=new Vn(e.rest,3);for(let r of[this.geometry,...e.triangles?[]:[this.lines=new Un]])r.setAttribute("position",s),r.setAttribute("shift",this.shift),r.setAttribute("value",this.value);if(e.triangles){this.geometry.setAttribute("normal",this.normal),this.geometry.setIndex(new Vn(e.triangles,1)),this.film=new Un;for(let r of["position","shift","normal"])this.film.setAttribute(r,this.geometry.getAttribute(r));this.film.setIndex(this.faces=new Vn(new Uint32Array(e.triangles.length),1).setUsage(Th))}this.lines?.setIndex(new Vn(e.sides,1)),this.update(new Int16Array(e.scene.points.length),0,!1)}shape;geometry=new Un;lines=null;film=null;shift;places;mean=[0,0,0];peak=0;normal;value;faces=null;seen;update(e,t,n){let{point:s,rest:r,corners:o}=this.shape,a=this.shift.array,l=this.places,c=0,h=0,u=0,d=0;for(let f=0;f<o;f++){let g=3*f,v=3*s[f],m=e[v],p=e[v+1],x=e[v+2];a[g]=m,a[g+1]=p,a[g+2]=x,l[g]=r[g]+m*t,l[g+1]=r[g+1]+p*t,l[g+2]=r[g+2]+x*t,h+=m,u+=p,d+=x,c=Math.max(c,m*m+p*p+x*x)}this.mean[0]=h*t/o,this.mean[1]=u*t/o,this.mean[2]=d*t/o,this.shift.needsUpdate=!0,this.peak=n?this.stretch():Math.sqrt(c)*t,this.shape.triangles&&this.normals(this.shape.triangles)}differs(e,t,n,s){let{triangles:r,corners:o}=this.shape;if(!r||!this.film||!this.faces)return!0;let{places:a,seen:l}=this,c=e.places,h=this.normal.array,[u,d]=[(.1*n)**2,(3*n)**2];for(let v=0;v<o;v++){let m=3*v,p=h[m],x=h[m+1],M=h[m+2],b=s;if(!b){let E=a[m]-c[m],y=a[m+1]-c[m+1],S=a[m+2]-c[m+2],U=E*p+y*x+S*M;b=U>0&&U*U>u*(p*p+x*x+M*M)||E*E+y*y+S*S>d}let C=p*(a[m]-t.x)+x*(a[m+1]-t.y)+M*(a[m+2]-t.z)<0;l[v]=(b?1:0)|(C?2:0)}let f=this.faces.array,g=0;for(let v=0;v<r.length;v+=3){let m=r[v],p=r[v+1],x=r[v+2];(l[m]|l[p]|l[x])===3&&(f[g++]=m,f[g++]=p,f[g++]=x)}return this.film.setDrawRange(0,g),this.faces.clearUpdateRanges(),this.faces.addUpdateRange(0,g),g&&(this.faces.needsUpdate=!0),g>0}dispose(){this.film?.dispose(),this.geometry.dispose(),this.lines?.dispose()}normals(e){let t=this.places,n=this.normal.array;n.fill(0);for(let s=0;s<e.length;s+=3){let r=3*e[s],o=3*e[s+1],a=3*e[s+2],l=t[o]-t[r],c=t[o+1]-t[r+1],h=t[o+2]-t[r+2],u=t[a]-t[r],d=t[a+1]-t[r+1],f=t[a+2]-t[r+2],g=c*f-h*d,v=h*u-l*f,m=l*d-c*u;n[r]+=g,n[r+1]+=v,n[r+2]+=m,n[o]+=g,n[o+1]+=v,n[o+2]+=m,n[a]+=g,n[a+1]+=v,n[a+2]+=m}this.normal.needsUpdate=!0}stretch(){let{sides:e,restLengths:t,degree:n,corner:s,point:r,corners:o}=this.shape,a=this.value.array;a.fill(0);for(let c=0;c<t.length;c++){let h=e[2*c],u=e[2*c+1],d=Math.abs(Jv(this.places,h,u)/Math.max(t[c],1e-12)-1);a[h]+=d/n[h],a[u]+=d/n[u]}let l=0;for(let c=0;c<o;c++)a[c]=a[s[r[c]]],l=Math.max(l,a[c]);return this.value.needsUpdate=!0,l}};function Jv(i,e,t){let n=i[3*e]-i[3*t],s=i[3*e+1]-i[3*t+1],r=i[3*e+2]-i[3*t+2];return Math.sqrt(n*n+s*s+r*r)}function YE(i,e,t){let n=new Set,s=[];for(let r=0;r<i.length;r++){let o=i[r],a=i[r%3===2?r-2:r+1],l=Math.min(o,a)*t+Math.max(o,a);n.has(l)||(n.add(l),s.push(e[o],e[a]))}return Uint32Array.from(s)}function JE(i,e){let t=e.length/3,n=new Float32Array(3*t),s=Array.from({length:i.length/3},()=>[]);for(let c=0;c<t;c++){let[h,u,d]=[0,1,2].map(p=>3*e[3*c+p]),f=[0,1,2].map(p=>i[u+p]-i[h+p]),g=[0,1,2].map(p=>i[d+p]-i[h+p]),v=[f[1]*g[2]-f[2]*g[1],f[2]*g[0]-f[0]*g[2],f[0]*g[1]-f[1]*g[0]],m=Math.hypot(...v)||1;for(let p=0;p<3;p++)n[3*c+p]=v[p]/m,s[e[3*c+p]].push(c)}let r=(c,h)=>n[3*c]*n[3*h]+n[3*c+1]*n[3*h+1]+n[3*c+2]*n[3*h+2]>$E,o=(c,h,u)=>{for(let d=0;d<3;d++)for(let f=0;f<3;f++)if(e[3*c+d]===e[3*h+f]&&e[3*c+d]!==u)return!0;return!1},a=[],l=new Uint32Array(e.length);return s.forEach((c,h)=>{let u=new Set(c);for(let d of c){if(!u.delete(d))continue;let f=[d];for(let g=0;g<f.length;g++)for(let v of u)r(f[g],v)&&o(f[g],v,h)&&(u.delete(v),f.push(v));for(let g of f)for(let v=0;v<3;v++)e[3*g+v]===h&&(l[3*g+v]=a.length);a.push(h)}c.length||a.push(h)}),{point:Uint32Array.from(a),triangles:l}}var ZE=nl.map(i=>new W(...Fs(i)).divideScalar(255)),Gh=class{scale={value:0};full={value:1};by={value:0};stops={value:ZE};apart;size;height={value:1};constructor(e,t){this.apart={value:.05*e};let n=t.restLengths,s=n.length?n.reduce((r,o)=>r+o,0)/n.length:e;this.size={value:Math.min(.17*s,.08*e)}}},Hh=class{constructor(e,t,n){this.seat=e;this.moving=new Vh(t);let{geometry:s,lines:r,film:o}=this.moving,a={...n,plain:this.plain,flash:this.flash},l=(c,h,u)=>{let d=new Fn({defines:Ho(),vertexShader:c.vertex,fragmentShader:c.fragment,uniforms:{...a,...h},transparent:u,depthWrite:!u,side:u?0:2});return this.made.push(d),d};if(t.triangles)this.body.add(new ln(s,l($v,{},!1))),this.shell.add(new ln(o,l(Yv,{colour:this.colour,strength:this.strength},!0)));else{let c={plain:this.colour,by:{value:2}};this.body.add(new Ao(s,l(Bh,{opacity:{value:1}},!1))),this.body.add(new To(r,l(Df,{opacity:{value:1}},!1))),this.shell.add(new Ao(s,l(Bh,{opacity:{value:.35},...c},!0))),this.shell.add(new To(r,l(Df,{opacity:{value:.35},...c},!0)))}for(let c of[...this.body.children,...this.shell.children])c.frustumCulled=!1;this.group.add(this.body,this.shell)}seat;moving;group=new pi;body=new pi;shell=new pi;made=[];plain={value:new W};colour={value:new W};flash={value:0};strength={value:1};against(e){this.moving.film?.setAttribute("own",e.shift)}paint(e,t){let[n,s,r]=Fs(e).map(o=>o/255);this.colour.value.set(n,s,r),this.plain.value.set(.9,.895,.875).lerp(this.colour.value,.22).multiplyScalar(t?.9:1),this.strength.value=t?1:.95}show(e,t){this.body.visible=e==="solid",this.shell.visible=e==="ghost",this.flash.value=t}thin(e,t,n){this.shell.visible&&(this.shell.visible=this.moving.differs(e,t,n,this.flash.value>0))}order(e){let[t,n,s]=this.moving.mean,r=e.x*t+e.y*n+e.z*s;for(let o of this.shell.children)o.renderOrder=10-r/(Math.abs(r)+1)}dispose(){this.moving.dispose();for(let e of this.made)e.dispose()}};var Zv=Ei()?128:256,Wh=class{mesh;target=new Kn(Zv,Zv,{minFilter:Oi,magFilter:Dn,generateMipmaps:!0,depthBuffer:!0});scene=new br;camera;cast=null;shade;constructor(e,t,n,s){let r=t-.1*n,o=2*n;this.mesh=new ln(new Sr(9*n,9*n),new Fn({defines:Ho(),vertexShader:Of.vertex,fragmentShader:Of.fragment,transparent:!0,depthWrite:!1,uniforms:{shadow:{value:this.target.texture},centre:{value:new xt(e.x,e.y)},line:{value:new W},dark:{value:new W},reach:{value:o},pitch:{value:io(n*.9)},strength:{value:.3},opacity:{value:.5}}})),this.mesh.position.set(e.x,e.y,r),this.mesh.renderOrder=-1,this.camera=new Io(-o,o,o,-o,0,12*n),this.camera.up.set(0,-1,0),this.camera.position.set(e.x,e.y,r-n),this.camera.lookAt(e.x,e.y,r),this.shade=new Fn({vertexShader:Ff.vertex,fragmentShader:Ff.fragment,side:2,uniforms:{scale:{value:0},ground:{value:r},reach:{value:1.6*n}}}),s&&(this.cast=new ln(s.geometry,this.shade),this.cast.frustumCulled=!1,this.scene.add(this.cast))}colours(e){let{line:t,dark:n,strength:s,opacity:r}=this.mesh.material.uniforms;e?t.value.set(.62,.68,.78):t.value.set(.36,.42,.52),e?n.value.set(0,0,.01):n.value.set(.1,.12,.2),s.value=e?.62:.34,r.value=e?.2:.26}shadow(e,t,n){this.cast&&(this.cast.geometry=t.geometry,this.shade.uniforms.scale.value=n,e.setRenderTarget(this.target),e.clear(),e.render(this.scene,this.camera),e.setRenderTarget(null))}dispose(){this.target.dispose(),this.mesh.geometry.dispose(),this.mesh.material.dispose(),this.shade.dispose()}};var Xh=class{constructor(e,t,n,s){this.connection=e;this.size=t;this.stiffness=n;this.flat=s;this.radius=.16*t}connection;size;stiffness;flat;action="free";point=-1;target=new W;radius;plane=new fi;offset=new W;pressed=0;get holds(){return this.action!=="free"}grab(e,t,n,s,r){this.action="grab",this.point=e,this.plane.setFromNormalAndCoplanarPoint(s,n),this.offset.subVectors(t,n),this.target.copy(t),this.send(r)}press(e,t,n){this.action="ball",this.point=-1,this.pressed=0,this.offset.copy(t).multiplyScalar(-this.radius),this.target.copy(e).add(this.offset),this.plane.setFromNormalAndCoplanarPoint(t,e),this.send(n)}push(e,t){if(this.action!=="ball"||this.pressed>=1)return!1;let n=Math.min(e/.35,1-this.pressed);return this.pressed+=n,this.shift(t.clone().multiplyScalar(n*this.radius)),!0}follow(e,t){let n=e.intersectPlane(this.plane,new W);!n||!this.holds||(this.target.copy(n).add(this.offset),this.limit(),this.send(t))}depth(e,t){this.holds&&!this.flat&&this.shift(t.clone().multiplyScalar(e))}shift(e){this.holds&&(this.offset.add(e),this.target.add(e),this.limit(),this.send())}release(e){this.holds&&(this.action="free",this.point=-1,this.send(e))}send(e){this.connection.point({action:this.action,point:Math.max(this.point,0),target:this.target.toArray(),radius:this.action==="ball"?this.radius:0,stiffness:this.stiffness,time:e})}limit(){this.flat&&(this.target.z=0);let e=this.target.length();e>50*this.size&&this.target.multiplyScalar(50*this.size/e)}};var Za=class i{element=document.createElement("div");taken=[];made=new Map;used=new Set;since=0;count=!0;constructor(e){this.element.className="ct-labels",this.element.setAttribute("aria-hidden","true"),e.append(this.element)}static wide(e,t){return 7.1*(e.length+t.length)+52}put(e,t,n,s,r,o,a){let l=this.made.get(e)??this.make(e);this.used.add(e);let c=`ct-label ct-${t}`;l.element.className!==c&&(l.element.className=c),l.seat!==n&&l.element.style.setProperty("--user",`var(--user-${(l.seat=n)%8})`),l.text.textContent!==s&&(l.text.textContent=s);let h=l.detail.textContent;h!==r&&(this.count||!h||!r)&&(l.detail.textContent=r),t==="hand"&&(a=this.clear(o,a,i.wide(s,r)));let u=`translate(${o.toFixed(1)}px, ${a.toFixed(1)}px)`;l.place!==u&&(l.element.style.transform=l.place=u)}make(e){let t=document.createElement("div"),[n,s]=[document.createElement("b"),document.createElement("span")];t.append(n,s),this.element.append(t);let r={element:t,text:n,detail:s,seat:-1,place:""};return this.made.set(e,r),r}clear(e,t,n){for(let s=0;s<6;s++){let r=this.taken.find(o=>e<o.x+o.wide&&o.x<e+n&&Math.abs(t-o.y)<24);if(!r)break;t=r.y-24}return this.taken.push({x:e,y:t,wide:n}),t}sweep(){this.taken.length=0;for(let[t,n]of this.made)this.used.has(t)||(n.element.remove(),this.made.delete(t));this.used.clear();let e=performance.now();this.count=e-this.since>=125,this.count&&(this.since=e)}};function Kv(i,e,t,n){if(!n||i.length<2)return[{seat:i[0]??0,x:0,y:0,width:e,height:t}];let s=e>=t,r=i.length-1,o=r===1?.5:.48,a=s?{seat:i[0],x:0,y:0,width:Math.round(e*o)-6/2,height:t}:{seat:i[0],x:0,y:0,width:e,height:Math.round(t*o)-6/2},[l,c]=s?[a.width+6,0]:[0,a.height+6],[h,u]=[e-l,t-c],d=1,f=0;for(let p=1;p<=r;p++){let x=Math.min(h/p,u/Math.ceil(r/p));x>f&&([f,d]=[x,p])}let g=Math.ceil(r/d),[v,m]=[(h-6*(d-1))/d,(u-6*(g-1))/g];return[a,...i.slice(1).map((p,x)=>({seat:p,x:Math.round(l+x%d*(v+6)),y:Math.round(c+Math.floor(x/d)*(m+6)),width:Math.round(v),height:Math.round(m)}))]}var kf=1.54,qh=class{constructor(e,t,n,s){this.size=t;this.cloud=n;this.camera.up.set(0,0,1),this.camera.near=t*.02,this.camera.far=t*60,this.home={target:e.clone(),yaw:s?-Math.PI/2:-1.08,pitch:s?kf:.36,zoom:1},this.goal=Bf(this.home),this.now=Bf(this.home)}size;cloud;camera=new Zn(30,1,.01,100);home;goal;now;fit=1;fits=new Map;aspect(e,t){this.camera.aspect=e/Math.max(t,1),this.fit=this.fitted(this.camera.aspect),this.camera.updateProjectionMatrix(),this.apply()}fitted(e){let t=e.toFixed(3),n=this.fits.get(t);if(n)return n;let{target:s,yaw:r,pitch:o}=this.home,a=new W(Math.cos(r)*Math.cos(o),Math.sin(r)*Math.cos(o),Math.sin(o)),l=new W(0,0,1).cross(a).normalize(),c=a.clone().cross(l),h=new W,u=Math.tan(this.camera.fov*Math.PI/360),d=3*Math.max(1,Math.floor(this.cloud.length/3/500)),f=.5*this.size;for(let g=0;g<this.cloud.length;g+=d)h.fromArray(this.cloud,g).sub(s),f=Math.max(f,h.dot(a)+(e<1?1.2:1.42)*Math.max(Math.abs(h.dot(l))/e,1.12*Math.abs(h.dot(c)))/u);return this.fits.set(t,f),f}turn(e,t){this.goal.yaw-=e*.0065,this.goal.pitch=Math.min(Math.max(this.goal.pitch+t*.0065,-kf),kf)}zoom(e){this.goal.zoom=Math.min(Math.max(this.goal.zoom*e,.12),6)}pan(e,t,n){let s=this.metres(n),[r,o]=this.axes();this.goal.target.addScaledVector(r,-e*s).addScaledVector(o,t*s)}reset(){this.goal=Bf(this.home)}metres(e){return 2*Math.tan(this.camera.fov*Math.PI/360)*this.now.zoom*this.fit/Math.max(e,1)}axes(){let e=new W,t=new W,n=new W;return this.camera.updateMatrixWorld(),this.camera.matrixWorld.extractBasis(e,t,n),[e,t,n.negate()]}step(e){let{now:t,goal:n}=this,s=Math.abs(n.yaw-t.yaw)+Math.abs(n.pitch-t.pitch)+Math.abs(Math.log(n.zoom/t.zoom))+n.target.distanceTo(t.target)/this.size;if(s===0)return!1;let r=s<.001?1:e;return t.yaw+=(n.yaw-t.yaw)*r,t.pitch+=(n.pitch-t.pitch)*r,t.zoom*=(n.zoom/t.zoom)**r,t.target.lerp(n.target,r),this.apply(),!0}apply(){let{target:e,yaw:t,pitch:n,zoom:s}=this.now,r=s*this.fit;this.camera.position.set(Math.cos(t)*Math.cos(n),Math.sin(t)*Math.cos(n),Math.sin(n)).multiplyScalar(r).add(e),this.camera.lookAt(e),this.camera.updateMatrixWorld()}};function Bf(i){return{...i,target:i.target.clone()}}var KE=new Ts(1,28,18),zf=Ei()?new Ts(1,10,7):new Ts(1,18,12),Vf=new Ro(1,1,1,Ei()?6:12,1,!0).translate(0,.5,0),jE=new Na(1,1,Ei()?10:18).translate(0,.5,0),QE=Ei()?new Po(1,.13,5,20):new Po(1,.13,8,36),eT=new W(0,1,0),Xo=new W,tT=new Qn;function Wo(i,e=1){let t=new Fn({defines:Ho(),vertexShader:Uf.vertex,fragmentShader:Uf.fragment,uniforms:{colour:{value:new W},opacity:{value:e}},transparent:e<1,depthWrite:e>=1});return qo(t,i),t}function qo(i,e){let[t,n,s]=Fs(e);i.uniforms.colour.value.set(t/255,n/255,s/255)}function $h(i,e,t,n){Xo.subVectors(t,e);let s=Xo.length();i.visible=s>1e-9,i.visible&&(i.position.copy(e),i.quaternion.copy(tT.setFromUnitVectors(eT,Xo.divideScalar(s))),i.scale.set(n,s,n))}var Yh=class{constructor(e,t,n){this.size=e;this.full=t;this.skin=Wo(n),this.cord=Wo(n),this.glass=Wo(n,.55);for(let r of[this.skin,this.cord,this.glass]){let o=Wo(n,.2);o.depthFunc=Mo,o.uniforms.colour=r.uniforms.colour,this.hidden.set(r,o)}let s=(r,o)=>{let a=new ln(r,o);if(a.frustumCulled=!1,this.group.add(a),Ei())return a;let l=new ln(r,this.hidden.get(o));return l.frustumCulled=!1,l.renderOrder=20,a.add(l),a};this.proxy=s(zf,this.skin),this.knot=s(zf,this.skin),this.rope=s(Vf,this.cord),this.lead=s(Vf,this.cord),this.shaft=s(Vf,this.skin),this.head=s(jE,this.skin),this.mark=s(QE,this.skin),this.group.visible=!1}size;full;group=new pi;spot=new W;force=0;skin;cord;glass;hidden=new Map;proxy;knot;rope;lead;shaft;head;mark;tip=new W;neck=new W;paint(e){qo(this.skin,e),qo(this.glass,e)}pose(e,t){let{size:n}=this,s=this.force=e.force.length();this.spot.copy(e.proxy);let r=Math.min(s/this.full,1),o=n*(.006+.012*r);if(qo(this.cord,pa(r,!1)),this.proxy.material=e.radius>0?this.glass:this.skin,this.proxy.geometry=e.radius>0?KE:zf,this.proxy.position.copy(e.proxy),this.proxy.scale.setScalar(e.radius>0?e.radius:n*.042),this.knot.visible=e.radius===0,this.knot.position.copy(e.place),this.knot.scale.setScalar(n*.026),$h(this.rope,e.place,e.proxy,o),$h(this.lead,e.proxy,e.target,o*.8),e.radius>0&&(this.rope.visible=!1),this.mark.visible=e.pointed,this.mark.position.copy(e.target),this.mark.quaternion.copy(t),this.mark.scale.setScalar(n*.045),this.shaft.visible=this.head.visible=r>.01&&!e.pointed,!this.shaft.visible)return;Xo.copy(e.force).divideScalar(s);let a=n*(.08+.72*r),l=e.radius>0?e.proxy:e.place;this.tip.copy(l).addScaledVector(Xo,a),this.neck.copy(l).addScaledVector(Xo,a-n*.09);let[c,h]=[this.tip,this.neck];$h(this.shaft,l,h,n*.013),$h(this.head,h,c,n*.036)}dispose(){for(let e of[this.skin,this.cord,this.glass,...this.hidden.values()])e.dispose()}};var jv=900,Qv=46,Jh=matchMedia("(prefers-reduced-motion: reduce)");function ey(i,e,t,n,s){return new Gf(i,e,t,n,s)}function nT(i){i.readPixels(0,0,1,1,i.RGBA,i.UNSIGNED_BYTE,new Uint8Array(4))}var Gf=class{constructor(e,t,n,s,r){this.scene=t;this.store=n;this.connection=s;this.stats=r;let o=t.radius||1,a=t.dimension<3;this.renderer=new Ph({antialias:!Ei(),alpha:!0,powerPreference:"high-performance"}),this.renderer.setClearAlpha(0),this.renderer.autoClear=!1,this.canvas=this.renderer.domElement,this.canvas.className="ct-canvas",this.canvas.tabIndex=0,this.canvas.setAttribute("role","application"),this.canvas.setAttribute("aria-label","The shared object. Drag it to pull; G grabs, arrows move, Escape lets go."),e.append(this.canvas),this.shape=new zh(t),this.common=new Gh(o,this.shape),this.orbit=new qh(new W(...t.centre),o,t.points,a),this.full=.6*t.stiffness*o,this.hold=new Xh(s,o,t.stiffness,a);for(let{seat:u}of t.users){let d=new Hh(u,this.shape,this.common),f=new Yh(o,this.full,xi(u,!1));this.copies.set(u,d),this.hands.set(u,f),this.world.add(d.group,f.group)}let l=1/0;for(let u=2;u<t.points.length;u+=3)l=Math.min(l,t.points[u]);this.ground=new Wh(new W(...t.centre),l,o,t.skin?this.mine.moving:null),this.ground.mesh.visible=!a,this.dot=new ln(new Ts(.022*o,20,14),this.dotPaint),this.dot.visible=!1,this.world.add(this.ground.mesh,this.dot),this.labels=new Za(e),this.furniture=new so(e,n,"Take hold of the object and pull. Drag beside it to look around."),this.touch=new Uh(this,n);let c=new ResizeObserver(()=>this.resize());c.observe(e);let h=()=>this.dress();this.ends.push(()=>c.disconnect(),zr(h),n.on("settings",h),n.on("seat",()=>{this.touch.release(),this.dress()}),n.on("frame",()=>this.draw()),n.on("state",()=>this.draw()),n.on("connection",()=>{n.connection==="open"&&this.hold.holds&&this.hold.send()})),this.resize(),this.dress()}scene;store;connection;stats;canvas;orbit;hold;renderer;world=new br;shape;common;copies=new Map;hands=new Map;ground;dot;dotPaint=Wo("#ffffff");labels;furniture;touch;ends=[];full;face=new Qn;proxy=new W;place=new W;goal=new W;posed={place:new W,proxy:new W,target:new W,force:new W,radius:0,pointed:!1};fresh=!0;hovered=null;area=[];width=0;height=0;shown=null;dirty=!0;came=0;shadowed={by:-1,left:0};last=0;handle=0;peak=0;pulsed={seat:-1,since:-1/0};quality=new Oh(()=>Math.min(devicePixelRatio||1,2));reset(){this.orbit.reset(),this.draw()}pulse(e){this.pulsed={seat:e,since:performance.now()},this.draw()}spot(e){let t=this.area[0],n=e??this.pick(t.x+t.width/2,t.y+t.height/2,t.width)?.point;if(n===void 0)return null;let s=Dh(this.orbit.camera,t,new W().fromArray(this.mine.moving.places,3*this.shape.corner[n]));return s&&{...s,point:n}}probe(){let e=this.canvas.getBoundingClientRect(),t=Dh(this.orbit.camera,this.area[0],this.hold.target);return{space:this,hold:this.hold,orbit:this.orbit,target:t&&[t.x+e.left,t.y+e.top]}}dispose(){cancelAnimationFrame(this.handle),this.handle=-1,this.touch.dispose();for(let e of this.ends)e();for(let e of[...this.copies.values(),...this.hands.values(),this.ground,this.dotPaint,this.dot.geometry,this.furniture])e.dispose();this.renderer.dispose(),this.renderer.forceContextLoss(),this.canvas.remove(),this.labels.element.remove()}ownCell(){return this.area[0]}cellAt(e,t){return this.area.find(n=>e>=n.x&&e<n.x+n.width&&t>=n.y&&t<n.y+n.height)??this.area[0]}pick(e,t,n){return this.cellAt(e,t)!==this.area[0]?null:Nh(this.mine.moving,this.orbit.camera,this.area[0],e,t,n)}aim(e,t){let n=this.canvas.getBoundingClientRect(),s=this.cellAt(e-n.left,t-n.top),r=(this.copies.get(s.seat)??this.mine).moving,o=zo(this.orbit.camera,s,e-n.left,t-n.top),a=Nh(r,this.orbit.camera,s,e-n.left,t-n.top,0),l=a??Nh(r,this.orbit.camera,s,e-n.left,t-n.top,1/0);if(!l)return null;let c=this.orbit.camera.getWorldDirection(new W),h=a?.surface??o.at(l.place.clone().sub(o.origin).dot(c)/o.direction.dot(c),new W);return{point:l.point,to:[h.x,h.y,h.z]}}hover(e){e?.point!==this.hovered?.point&&this.draw(),this.hovered=e;let t=e?this.store.settings.tool:"";this.canvas.dataset.over!==t&&(this.canvas.dataset.over=t)}mayAct(){return this.connection.mayAct}force(){return Math.min(this.pull()/this.full,1)}draw(){this.dirty=!0,this.handle||(this.handle=requestAnimationFrame(e=>this.tick(e)))}get mine(){return this.copies.get(this.store.seat)??this.copies.values().next().value}get side(){return this.store.settings.layout==="side"}pull(){if(!this.hold.holds||this.fresh)return 0;let e=this.shown?.copies.find(t=>t.seat===this.store.seat);return this.hold.action==="ball"?e?.mode==="ball"?Math.hypot(...e.force):0:this.scene.stiffness*this.place.distanceTo(this.hold.target)}resize(){let e=this.canvas.parentElement?.getBoundingClientRect();!e||e.width<1||e.height<1||(this.width=Math.round(e.width),this.height=Math.round(e.height),this.renderer.setPixelRatio(this.quality.ratio),this.renderer.setSize(this.width,this.height),this.arrange(),this.draw())}arrange(){let e=this.scene.users.map(n=>n.seat).filter(n=>n!==this.store.seat),t=this.side&&this.height>3*Qv?Qv:0;this.area=Kv([this.store.seat,...e],this.width,this.height-t,this.side);for(let n of this.area)n.y+=t;this.furniture.rules(this.area.length>1?this.area:[])}dress(){let{settings:e}=this.store,t=Us(e.theme),n={displacement:0,stress:1,plain:2}[e.colour];n!==this.common.by.value&&(this.peak=0),this.common.by.value=n;for(let[s,r]of this.copies)r.paint(xi(s,t),t),r.against(this.mine.moving),this.hands.get(s).paint(xi(s,t));qo(this.dotPaint,t?"#FFFFFF":"#111827"),this.ground.colours(t),this.arrange(),this.shown=null,this.draw()}tick(e){this.handle=0;let t=Math.min((e-this.last)/1e3,.1);this.last=e;let n=this.store.frame!==null&&this.store.frame!==this.shown,s=this.store.came-this.came-1;n&&(this.came=this.store.came,this.take(this.store.frame));let r=this.orbit.step(Jh.matches?1:1-Math.exp(-t*18));r=this.touch.step(t)||r,r=this.haptic(t)||r,r=this.range(t)||r,r=e-this.pulsed.since<jv||r,(this.dirty||r)&&(this.dirty=!1,this.render(e),n&&(this.stats.finishing&&nT(this.renderer.getContext()),this.stats.drew(this.shown.echo,this.shown.received,performance.now()),this.quality.took(s,t)&&this.resize())),r&&this.draw()}take(e){this.shown=e,this.common.scale.value=e.scale;let t=this.side||this.store.settings.ghosts,n=this.common.by.value===1,s=0;for(let{seat:r,displacement:o}of e.copies){let a=this.copies.get(r);!a||!(t||a===this.mine)||(a.moving.update(o,e.scale,n&&(this.side||a===this.mine)),(this.side||a===this.mine)&&(s=Math.max(s,a.moving.peak)))}this.peak=Math.max(s,this.peak*.998)}haptic(e){if(!this.hold.holds)return!(this.fresh=!0);let{moving:t}=this.mine;if(this.hold.action==="grab")this.place.fromArray(t.places,3*this.shape.corner[this.hold.point]);else{let o=this.shown?.copies.find(a=>a.seat===this.store.seat);o?.mode==="ball"?this.place.fromArray(o.place):this.place.copy(this.hold.target)}let n=this.force(),s=this.hold.action==="ball"?1:.6*n/(n+.45),r=this.goal.lerpVectors(this.hold.target,this.place,s);return this.fresh||Jh.matches?this.proxy.copy(r):this.proxy.lerp(r,1-Math.exp(-e*55)),this.fresh=!1,this.proxy.distanceTo(r)>1e-4*this.scene.radius}range(e){let t=this.common.by.value===1,n=io(Math.max(this.peak,t?.02:.04*this.scene.radius));this.furniture.legend(this.store.settings.colour,t?`${Math.round(n*100)} %`:Ll(n));let{full:s}=this.common;return s.value+=(n-s.value)*(Jh.matches?1:1-Math.exp(-e*6)),Math.abs(s.value-n)>.01*n}render(e){let{renderer:t,common:n}=this,[,,s]=this.orbit.axes();this.orbit.camera.getWorldQuaternion(this.face),t.setScissorTest(!1),t.setViewport(0,0,this.width,this.height),t.clear();for(let r of this.area){this.orbit.aspect(r.width,r.height);let o=this.copies.get(r.seat)??this.mine,a=this.shown?.copies;for(let[c,h]of this.copies){let u=!a||a.some(f=>f.seat===c),d=!this.side&&this.store.settings.ghosts&&u&&a;h.show(h===o?"solid":d?"ghost":"hidden",this.flash(c,e)),h.thin(this.mine.moving,this.orbit.camera.position,n.apart.value),h.order(s)}for(let[c,h]of this.hands)h.group.visible=(!this.side||c===r.seat)&&this.pose(c,h);this.dot.visible=!!this.hovered&&r===this.area[0],this.hovered&&this.dot.position.fromArray(this.mine.moving.places,3*this.shape.corner[this.hovered.point]),(this.side||o.seat!==this.shadowed.by||--this.shadowed.left<=0)&&(this.ground.shadow(t,o.moving,n.scale.value),this.shadowed={by:o.seat,left:this.quality.shadows}),n.height.value=r.height*this.quality.ratio;let l=this.height-r.y-r.height;t.setScissorTest(!0),t.setScissor(r.x,l,r.width,r.height),t.setViewport(r.x,l,r.width,r.height),t.render(this.world,this.orbit.camera),t.setScissorTest(!1),this.name(r)}this.orbit.aspect(this.area[0].width,this.area[0].height),this.labels.sweep()}flash(e,t){let n=(t-this.pulsed.since)/jv;return e!==this.pulsed.seat||n>=1||n<0?0:Jh.matches?.6:Math.sin(n*Math.PI*3)**2*(1-n)}pose(e,t){let n=this.posed;if(e===this.store.seat&&this.hold.holds){let r=this.pull();return n.place.copy(this.place),n.proxy.copy(this.proxy),n.target.copy(this.hold.target),n.force.subVectors(n.target,n.place).setLength(r),n.radius=this.hold.action==="ball"?this.hold.radius:0,n.pointed=!0,t.pose(n,this.face),!0}let s=this.shown?.copies.find(r=>r.seat===e);return!s?.hasHand||s.mode==="free"||s.node<0&&s.radius===0?!1:(n.place.fromArray(s.place),n.target.fromArray(s.target),n.force.fromArray(s.force),n.proxy.copy(s.radius>0?n.place:n.target),n.radius=s.radius,n.pointed=!1,t.pose(n,this.face),!0)}name(e){let{seat:t,state:n}=this.store,s=r=>this.scene.users.find(o=>o.seat===r)?.name??`User ${r+1}`;if(this.side){let r=n?Il(n,t).get(e.seat):0,o=this.shown?.copies.find(h=>h.seat===e.seat),a=n?.members[e.seat]?.here===!1||!o,l=o&&!o.direct?`, shown ${Gs(o.age)} old`:"",c=e.seat===t?"you":a?"not here":r===void 0?`out of reach${l}`:e.width<240?`+${Gs(r)}`:`feels you ${Gs(r)} later${l}`;this.labels.put(`cell${e.seat}`,"title",e.seat,s(e.seat),c,e.x+14,e.y+12)}for(let[r,o]of this.hands){if(!o.group.visible)continue;let a=Dh(this.orbit.camera,e,o.spot);if(!a||a.x<e.x||a.x>e.x+e.width||a.y<e.y||a.y>e.y+e.height)continue;let l=o.force>.005*this.full?Nl(o.force):"";if(this.side&&!l)continue;let c=this.side?"":r===t&&this.hold.holds?"You":s(r);a.x=Math.max(Math.min(a.x,e.x+e.width-Za.wide(c,l)),e.x),a.y=Math.max(a.y,e.y+34),this.labels.put(`hand${r}`,"hand",r,c,l,a.x,a.y)}}};var iT="The picture needs WebGL 2, which this browser does not give; everything beside it works.";function ty(i,e,t,n){let s=null,r="",o=()=>{let l=e.scene;if(!(!l||l.started===r)){r=l.started,s?.dispose(),s=null,i.classList.add("ct-stage");try{s=(l.dimension===1?Xv:ey)(i,l,e,t,n)}catch(c){i.replaceChildren(Object.assign(document.createElement("p"),{className:"ct-sorry",textContent:iT})),console.warn(c)}}},a=e.on("scene",o);return o(),{reset:()=>s?.reset(),probe:()=>s?.probe?.()??{},spot:l=>{let c=s?.spot(l),h=i.getBoundingClientRect();return c?{...c,x:c.x+h.left,y:c.y+h.top}:null},pulse:l=>s?.pulse(l),aim:(l,c)=>s?.aim(l,c)??null,dispose:()=>{a(),s?.dispose()}}}var Zh=class{finishing=!1;frames=0;fps=0;dragToMesh=[];echoMs=[];waiting=[];since=0;counted=0;pointed(e,t){this.waiting.push({number:e,time:t}),this.waiting.length>600&&this.waiting.shift()}drew(e,t,n){for(this.frames++,this.counted++,n-this.since>=1e3&&(this.fps=this.counted*1e3/(n-this.since),this.since=n,this.counted=0);this.waiting.length&&this.waiting[0].number<=e;){let{time:s}=this.waiting.shift();ny(this.dragToMesh,n-s),ny(this.echoMs,t-s)}}};function ny(i,e){i.push(e),i.length>600&&i.shift()}var iy=["x","y","z","force","energy","supplied","lost","linked"],Kh=class{seconds=20;capacity=1240;count=0;version=0;axis=0;next=0;times=new Float64Array(1240);tracks=new Map;reach=[0,0,0];get seats(){return[...this.tracks.keys()].sort((e,t)=>e-t)}clear(){this.count=this.next=0,this.axis=0,this.reach.fill(0),this.tracks=new Map,this.version++}add(e){let t=this.next;if(this.count&&e.time<this.times[(t+1240-1)%1240])return;for(let s of this.tracks.values())for(let r of iy)s[r][t]=NaN;let n=Math.max(1,Math.floor(e.points/1500));for(let s of e.copies){let r=this.track(s.seat),o=s.displacement,a=0,l=0,c=0,h=0;for(let d=0;d<e.points;d+=n,h++)a+=o[3*d],l+=o[3*d+1],c+=o[3*d+2];let u=e.scale/Math.max(h,1);r.x[t]=a*u,r.y[t]=l*u,r.z[t]=c*u,r.force[t]=Math.hypot(...s.force),r.energy[t]=s.energy,r.supplied[t]=s.supplied,r.lost[t]=s.lost,r.linked[t]=s.linked,this.reach[0]=Math.max(this.reach[0],Math.abs(a*u)),this.reach[1]=Math.max(this.reach[1],Math.abs(l*u)),this.reach[2]=Math.max(this.reach[2],Math.abs(c*u))}for(let s of[0,1,2])this.reach[s]>1.5*this.reach[this.axis]&&(this.axis=s);this.times[t]=e.time,this.next=(t+1)%1240,this.count=Math.min(this.count+1,1240),this.version++}time(){return this.ordered(this.times,new Float64Array(this.count))}series(e,t){let n=this.tracks.get(t),s=new Float32Array(this.count);return n?this.ordered(n[e==="position"?["x","y","z"][this.axis]:e],s):s.fill(NaN)}before(e,t){let n=this.tracks.get(e);if(!n||!this.count)return NaN;let s=l=>(this.next-1-l+2*1240)%1240,r=this.times[s(0)]-t,o=0,a=this.count-1;for(;o<a;){let l=o+a>>1;this.times[s(l)]>r?o=l+1:a=l}return n.x[s(o)]}ordered(e,t){let n=(this.next-this.count+1240)%1240,s=Math.min(this.count,1240-n);return t.set(e.subarray(n,n+s)),t.set(e.subarray(0,this.count-s),s),t}track(e){let t=this.tracks.get(e);return t||(t=Object.fromEntries(iy.map(n=>[n,new Float32Array(1240).fill(NaN)])),this.tracks.set(e,t)),t}};var sy={layout:"overlay",colour:"displacement",theme:"auto",tool:"grab",ghosts:!0},ry="cotouch.settings";function sT(){try{return{...sy,...JSON.parse(localStorage.getItem(ry)??"{}")}}catch{return{...sy}}}var jh=class{scene=null;state=null;frame=null;came=0;connection="connecting";refusal="";seat=0;history=new Kh;settings=sT();listeners=new Map;wished;constructor(e=null){this.wished=e,e!==null&&(this.seat=e)}on(e,t){let n=this.listeners.get(e)??new Set;return this.listeners.set(e,n.add(t)),()=>n.delete(t)}emit(e){for(let t of[...this.listeners.get(e)??[]])t()}set(e){this.settings={...this.settings,...e};try{localStorage.setItem(ry,JSON.stringify(this.settings))}catch{}this.emit("settings")}take(e){e!==this.seat&&(this.seat=this.wished=e,this.emit("seat"))}show(e){this.scene?.started!==e.started&&(this.state=this.frame=null,this.history.clear()),this.scene=e;let t=e.users.map(r=>r.seat),n=this.wished!==null&&t.includes(this.wished)?this.wished:e.own[0]??t[0]??0,s=n!==this.seat;this.seat=n,this.emit("scene"),s&&this.emit("seat")}told(e){this.state=e,this.emit("state")}drawn(e){this.frame=e,this.came++,this.history.add(e),this.emit("frame")}connected(e,t=""){e===this.connection&&t===this.refusal||(this.connection=e,this.refusal=t,this.emit("connection"))}};var rT=new URLSearchParams(location.search),Hf=Number(rT.get("user")),oT=new URLSearchParams(location.hash.slice(1)).get("token")||null,$o=new jh(Number.isInteger(Hf)&&Hf>=1?Hf-1:null),Wf=()=>up($o.settings.theme);Wf();$o.on("settings",Wf);zr(Wf);var Xf=new Zh,Qh=new sl($o,oT,`${location.protocol==="https:"?"wss":"ws"}://${location.host}/ws`);Qh.onPoint=(i,e)=>Xf.pointed(i,e);var oy=zg(document.getElementById("app"),$o,Qh),ay=ty(oy.stageElement,$o,Qh,Xf);oy.attach(ay);window.cotouch={store:$o,connection:Qh,stage:ay,stats:Xf};
